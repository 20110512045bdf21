// Copy of the server's undo and redo steps. The page sends these steps when it opens a session on a restarted server.
import { LIMITS, type Scene } from "../generated/protocol";
import { applyPatch, diff, equal, type JsonObject } from "../model/merge_patch";

/** Merge patches. The first patch applies to the current scene, each further patch to the result of the one before. */
export interface Steps {
  undo: JsonObject[];
  redo: JsonObject[];
}

const [, MOST_STEPS] = LIMITS["session.open"].undo;
/** Most bytes of a scene with its steps as JSON. The usual limit of a message is 1 MiB. */
const MOST_BYTES = 1_000_000;
/** Bytes of the message that are neither scene nor steps. */
const REST_OF_REQUEST = 2048;
/** Gesture name for changes of other clients. Their gestures are unknown: consecutive changes count as one step. */
const OF_OTHERS = "others";

export class SceneHistory {
  /** The server's scene. The model's scene may also contain changes that the server has not accepted. */
  private scene: JsonObject | null = null;
  private steps: Steps = { undo: [], redo: [] };
  private gesture = "";

  /** The newest scene that the server has accepted; null before a session. */
  get accepted(): Scene | null {
    return this.scene as unknown as Scene | null;
  }

  /** Gesture name of this page's newest step; empty if the newest step is not of this page. */
  get newestGesture(): string {
    return this.gesture === OF_OTHERS ? "" : this.gesture;
  }

  /** Call when the server has accepted a change of this page. */
  changed(patch: JsonObject, gesture: string): void {
    if (this.scene !== null) this.become(applyPatch(this.scene, patch) as JsonObject, gesture);
  }

  /** Makes the next change a new step. Call when the session is new: its server does not know the earlier gesture. */
  endGesture(): void {
    this.gesture = "";
  }

  /** Call with a scene that the server has sent. Any client may have changed the scene. */
  found(scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null) this.scene = found;
    else this.become(found, OF_OTHERS);
  }

  /**
   * Call after an undo or redo, with the server's scene. The scene may be several steps away, because the server skips
   * steps whose scene it cannot show.
   */
  moved(step: keyof Steps, scene: Scene): void {
    const found = scene as unknown as JsonObject;
    if (this.scene === null || equal(this.scene, found)) return;
    const taken = [...this.steps[step]];
    const back = [...this.steps[step === "undo" ? "redo" : "undo"]];
    let at = this.scene;
    while (!equal(at, found)) {
      const patch = taken.shift();
      if (patch === undefined) {
        this.found(scene); // the steps of this page do not lead to this scene
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

  /**
   * Returns the steps to open a session with, as many as fit into a message of `messageBytes`. The scene may contain
   * changes that the server has not accepted.
   */
  around(scene: Scene, messageBytes?: number): Steps {
    const begun = scene as unknown as JsonObject;
    if (this.scene === null) return { undo: [], redo: [] };
    if (equal(begun, this.scene)) return fitting(this.steps, begun, messageBytes);
    return fitting({ undo: [diff(begun, this.scene), ...this.steps.undo], redo: [] }, begun, messageBytes);
  }

  /** Text for restore(). Empty before a session. */
  asText(): string {
    return this.scene === null
      ? ""
      : JSON.stringify({ scene: this.scene, gesture: this.gesture, ...fitting(this.steps, this.scene) });
  }

  /** `text`: result of asText() before a reload of the page. Ignores an invalid text. Call before the first session. */
  restore(text: string): void {
    const saved = savedIn(text);
    if (saved === null) return;
    this.scene = saved.scene;
    this.gesture = saved.gesture;
    this.steps = { undo: saved.undo, redo: saved.redo };
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

type Saved = { scene: JsonObject; gesture: string } & Steps;

function savedIn(text: string): Saved | null {
  try {
    const { scene, gesture = "", undo, redo } = JSON.parse(text) as Partial<Saved>;
    const isWhole =
      typeof scene === "object" && typeof gesture === "string" && Array.isArray(undo) && Array.isArray(redo);
    return isWhole ? { scene, gesture, undo, redo } : null;
  } catch {
    return null;
  }
}

const bytesOf = (value: JsonObject): number => new TextEncoder().encode(JSON.stringify(value)).length;

/** Returns as many of the nearest steps as fit into one message with the scene. */
function fitting({ undo, redo }: Steps, scene: JsonObject, messageBytes = Infinity): Steps {
  let left = Math.min(MOST_BYTES, messageBytes - REST_OF_REQUEST) - bytesOf(scene);
  const near = (patches: JsonObject[]): JsonObject[] => {
    const fit: JsonObject[] = [];
    for (const patch of patches.slice(0, MOST_STEPS)) {
      left -= bytesOf(patch) + 1; // with the comma behind it
      if (left < 0) break;
      fit.push(patch);
    }
    return fit;
  };
  return { undo: near(undo), redo: near(redo) };
}
