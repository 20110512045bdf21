// What can be undone and redone, as the server keeps it: for a server that was restarted and has forgotten it.
import type { Scene } from "../generated/protocol";
import { applyPatch, diff, equal, type JsonObject } from "../model/merge_patch";

/** Merge patches, the nearest step first: the first one applies to the scene, each other to what the one before it makes. */
export interface Steps {
  undo: JsonObject[];
  redo: JsonObject[];
}

const MOST_STEPS = 50;
/** Of all patches as JSON: the message that hands them over has at most 1 MiB. */
const MOST_CHARACTERS = 400_000;
/** Changes of other clients in a row are one step here: their gestures are not told. */
const OF_OTHERS = "others";

export class SceneHistory {
  /** The server's scene; null: no session was open yet. */
  private scene: JsonObject | null = null;
  private steps: Steps = { undo: [], redo: [] };
  private gesture = "";

  /** The server has taken a change of this page. */
  changed(patch: JsonObject, gesture: string): void {
    if (this.scene !== null) this.become(applyPatch(this.scene, patch) as JsonObject, gesture);
  }

  /** The server's scene is this, whoever changed it. */
  found(scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null) this.scene = found;
    else this.become(found, OF_OTHERS);
  }

  /** Undo or redo has led to this scene. The server passes over steps that it cannot show. */
  moved(step: keyof Steps, scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null || equal(this.scene, found)) return;
    const taken = [...this.steps[step]];
    const back = [...this.steps[step === "undo" ? "redo" : "undo"]];
    let at = this.scene;
    while (!equal(at, found)) {
      const patch = taken.shift();
      if (patch === undefined) {
        this.found(scene); // where this page has never been
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

  /** The steps around a session that begins with this scene, which may hold changes that no server has seen. */
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

/** The steps that lie nearest, as many as one message holds. */
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
