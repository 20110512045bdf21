// Copy of the server's undo and redo steps. Restores them after a server restart.
import type { Scene } from "../generated/protocol";
import { applyPatch, diff, equal, type JsonObject } from "../model/merge_patch";

/** Merge patches, nearest step first. The first applies to the scene, each next one to the previous result. */
export interface Steps {
  undo: JsonObject[];
  redo: JsonObject[];
}

const MOST_STEPS = 50;
/** Limit of all patches as JSON: the message that carries them has at most 1 MiB. */
const MOST_CHARACTERS = 400_000;
/** Gesture of other clients' changes. Consecutive ones are one step: their gestures are unknown. */
const OF_OTHERS = "others";

export class SceneHistory {
  /** The server's scene; null until a session was open. */
  private scene: JsonObject | null = null;
  private steps: Steps = { undo: [], redo: [] };
  private gesture = "";

  /** Call when the server has accepted a change of this page. */
  changed(patch: JsonObject, gesture: string): void {
    if (this.scene !== null) this.become(applyPatch(this.scene, patch) as JsonObject, gesture);
  }

  /** Call with the server's scene, whichever client changed it. */
  found(scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null) this.scene = found;
    else this.become(found, OF_OTHERS);
  }

  /** Call with the scene after an undo or redo. The server skips steps that it cannot show. */
  moved(step: keyof Steps, scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null || equal(this.scene, found)) return;
    const taken = [...this.steps[step]];
    const back = [...this.steps[step === "undo" ? "redo" : "undo"]];
    let at = this.scene;
    while (!equal(at, found)) {
      const patch = taken.shift();
      if (patch === undefined) {
        this.found(scene); // a scene unknown to this page
        return;
      }
      const next = applyPatch(at, patch) as JsonObject;
      back.unshift(diff(next, at));
      at = next;
    }
    this.scene = at;
    this.gesture = "";
    this.steps = step === "undo" ? { undo: taken, redo: back } : { undo: back, redo: taken };
  }

  /** Steps for a session that begins with this scene. The scene may have changes unknown to the server. */
  around(scene: Scene): Steps {
    const begun = scene as unknown as JsonObject;
    if (this.scene === null) return { undo: [], redo: [] };
    if (equal(begun, this.scene)) return fitting(this.steps);
    return fitting({ undo: [diff(begun, this.scene), ...this.steps.undo], redo: [] });
  }

  forget(): void {
    this.scene = null;
    this.steps = { undo: [], redo: [] };
    this.gesture = "";
  }

  private become(next: JsonObject, gesture: string): void {
    if (this.scene === null || equal(next, this.scene)) return;
    const [newest, ...older] = this.steps.undo;
    const before = gesture === this.gesture && newest !== undefined ? applyPatch(this.scene, newest) : null;
    const undo =
      before === null
        ? [diff(next, this.scene), ...this.steps.undo].slice(0, MOST_STEPS)
        : [diff(next, before as JsonObject), ...older];
    this.steps = { undo, redo: [] };
    this.gesture = gesture;
    this.scene = next;
  }
}

/** The nearest steps that fit in one message. */
function fitting({ undo, redo }: Steps): Steps {
  let left = MOST_CHARACTERS;
  const near = (patches: JsonObject[]): JsonObject[] => {
    const fit: JsonObject[] = [];
    for (const patch of patches.slice(0, MOST_STEPS)) {
      left -= JSON.stringify(patch).length;
      if (left < 0) break;
      fit.push(patch);
    }
    return fit;
  };
  return { undo: near(undo), redo: near(redo) };
}
