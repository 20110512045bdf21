// Changes the scene of the model. A change applies to the local scene at once. The changes of one gesture are merged
// until the next animation frame, and then sent to the server.
import { batch } from "@preact/signals";
import type { Layer, Revision, Scene, SessionState } from "../generated/protocol";
import { applyPatch, composePatches, diff, keepEqual, type Json, type JsonObject } from "../model/merge_patch";
import type { Model } from "../model/model";
import { Disconnected } from "./rpc";
import { PatchesAtOnce } from "./patches_at_once";
import { SceneHistory, type Steps } from "./scene_history";
import { removedBetween, strayLayers, withoutLayers } from "./stray_layers";

export interface SceneServer {
  patch(patch: JsonObject, gesture: string): Promise<Revision>;
  undo(): Promise<SessionState>;
  redo(): Promise<SessionState>;
  get(): Promise<SessionState>;
}

/** Revision of a session that the server has just opened. */
const FIRST_REVISION = 1;

export type Step = "undo" | "redo";

/**
 * Members of the model that only the editor writes. canUndo and canRedo come from the server, because the server's
 * history may be longer than the page's copy (scene_history.ts).
 */
export type EditedState = Pick<Model, "scene" | "canUndo" | "canRedo" | "pending">;

export interface EditorEvents {
  /** The local scene may have changed. `before` is the scene before the change. Called within a batch of signals. */
  changed(before: Scene | null): void;
  /**
   * The server has accepted a change made at `since` (performance.now). `scene` is the server's scene at this revision.
   * Called within a batch of signals.
   */
  accepted(revision: number, since: number, scene: Scene): void;
  refused(error: Error): void;
  /** A change of this layer was dropped, because another client has removed the layer. */
  gone(layer: Layer): void;
  /** The server refused an undo or redo, because it cannot show the resulting scene. */
  stuck(step: Step, error: Error): void;
}

export interface Timing {
  now(): number;
  requestFrame(callback: () => void): void;
}

interface Change {
  patch: JsonObject;
  gesture: string;
  since: number;
  /**
   * The change of a removed layer was dropped from the patch, and the user has been told this. A refusal of the rest by
   * the server is then not reported.
   */
  targetsRemovedLayer?: boolean;
}

/** Whether the server has steps to undo or redo. Absent members are unknown. */
type Allowed = Partial<Pick<Revision, "can_undo" | "can_redo">>;

const patched = (scene: Scene, patch: JsonObject): Scene =>
  applyPatch(scene as unknown as Json, patch) as unknown as Scene;

const keptEqual = (before: Scene | null, after: Scene): Scene =>
  keepEqual(before as unknown as Json, after as unknown as Json) as unknown as Scene;

export class SceneEditor {
  private server: SceneServer | null = null;
  private queue: Change[] = [];
  private unanswered: Change[] = [];
  /** Whether the connection ended while changes were unanswered. The server may lack these changes. */
  private lostUnanswered = false;
  /** Whether the local scene may be wrong. If so, the server's scene is fetched after all changes are answered. */
  private doubtful = false;
  private asking = false;
  /** Number of unanswered undos, redos and proposed scenes. */
  private travelling = 0;
  private patchesAtOnce = new PatchesAtOnce();
  private frameRequested = false;
  private gestures = 0;
  private newestGesture: string;
  private held: (() => void) | null = null;
  /** Last state of layers that other clients have removed, by id. */
  private readonly lost = new Map<string, Layer>();
  private readonly history = new SceneHistory();

  constructor(
    private readonly state: EditedState,
    private readonly events: EditorEvents,
    private readonly timing: Timing,
    private readonly name: string,
  ) {
    this.newestGesture = name;
  }

  get scene(): Scene | null {
    return this.state.scene.peek();
  }

  get isConnected(): boolean {
    return this.server !== null;
  }

  /** Whether a change, an undo, a redo or a proposed scene waits for the server's answer. */
  get isPending(): boolean {
    return this.differsFromServer || this.travelling > 0;
  }

  private get differsFromServer(): boolean {
    return this.queue.length > 0 || this.unanswered.length > 0 || this.lostUnanswered;
  }

  /** Returns the steps to send when the page opens the session again, in a message of at most `messageBytes`. */
  stepsAround(scene: Scene, messageBytes?: number): Steps {
    return this.history.around(scene, messageBytes);
  }

  /** Text for restoreSteps() after a reload: the server's scene, its undo and redo steps. Empty before a session. */
  stepsAsText(): string {
    return this.history.asText();
  }

  /** Call before the first connected(). */
  restoreSteps(text: string): void {
    this.history.restore(text);
    this.newestGesture = this.history.newestGesture || this.name;
  }

  /** All changes with one gesture name are one undo step. */
  newGesture(): string {
    return `${this.name}-${++this.gestures}`;
  }

  /**
   * Postpones a change that needs an answer of the server. makeHeld() calls `make`, which makes the change. Every other
   * change of the user, undo and redo calls makeHeld() first, so that undo steps have the order of the user's actions.
   * Replaces an earlier postponed change.
   */
  hold(make: () => void): void {
    this.held = make;
  }

  makeHeld(): void {
    const make = this.held;
    this.held = null;
    make?.();
  }

  change(patch: object, gesture = this.newGesture()): void {
    this.makeHeld();
    this.changeAutomatically(patch, gesture);
  }

  /** For a change that is not an action of the user. Does not call makeHeld(). */
  changeAutomatically(patch: object, gesture: string): void {
    const { scene } = this;
    if (scene === null) return;
    const part = this.withoutLost(patch as JsonObject, scene);
    const changed = keptEqual(scene, patched(scene, part));
    if (changed === scene) return;
    this.newestGesture = gesture;
    const newest = this.queue.at(-1);
    const both = newest?.gesture === gesture ? composePatches(newest.patch, part) : null;
    if (newest !== undefined && both !== null) newest.patch = both;
    else this.queue.push({ patch: part, gesture, since: this.timing.now() });
    this.show(changed);
    this.requestFlush();
  }

  /**
   * Makes an automatic change. One undo reverts this change and the previous change, even if the page was reloaded
   * between the two. After a restart of the server, undo reverts this change alone.
   */
  amend(patch: object): void {
    this.changeAutomatically(patch, this.newestGesture);
  }

  replace(scene: Scene, gesture?: string): void {
    this.makeHeld();
    const before = this.scene;
    if (before === null) return;
    this.change(diff(before as unknown as JsonObject, scene as unknown as JsonObject), gesture);
  }

  async undo(): Promise<void> {
    const stuck = (error: Error): void => {
      // Undo stays disabled until an answer of the server enables it.
      this.state.canUndo.value = false;
      this.events.stuck("undo", error);
    };
    const moved = (scene: Scene): void => this.history.moved("undo", scene);
    await this.travel((server) => server.undo(), moved, stuck);
  }

  async redo(): Promise<void> {
    const stuck = (error: Error): void => {
      this.state.canRedo.value = false;
      this.events.stuck("redo", error);
    };
    const moved = (scene: Scene): void => this.history.moved("redo", scene);
    await this.travel((server) => server.redo(), moved, stuck);
  }

  /** Adopts the state of the opened session. Sends the changes made while disconnected as one undo step. */
  connected(server: SceneServer, state: SessionState): void {
    const mine = this.scene;
    const unsent = this.differsFromServer;
    this.server = server;
    this.patchesAtOnce = new PatchesAtOnce();
    this.unanswered = [];
    this.queue = [];
    this.doubtful = this.asking = false;
    this.travelling = 0;
    this.history.found(state.scene);
    if (state.revision === FIRST_REVISION) this.history.endGesture();
    this.adopt(state, []);
    if (unsent && mine !== null) this.replace(mine);
  }

  disconnected(): void {
    this.server = null;
    this.lostUnanswered ||= this.unanswered.length > 0;
    this.unanswered = [];
    this.travelling = 0;
    batch(() => {
      this.allow({ can_undo: false, can_redo: false }); // undo and redo need the server, which keeps the history
      this.show(this.scene);
    });
  }

  /**
   * Drops the history and all changes that the server has not accepted, so that connected() adopts the server's scene.
   * Call before connected() if the user has chosen another scene.
   */
  forget(): void {
    this.queue = [];
    this.unanswered = [];
    this.lostUnanswered = false;
    this.lost.clear();
    this.history.forget();
  }

  /** Adopts a scene that another client has changed. Applies the unanswered changes of this page again. */
  overheard(scene: Scene): void {
    this.history.found(scene);
    this.adopt({ scene }, this.unanswered);
    this.doubt(); // fetches canUndo and canRedo, which the notification does not contain
  }

  /** Sends the scene as one change. The local scene changes only after the server has accepted the scene. */
  async propose(scene: Scene): Promise<void> {
    this.makeHeld();
    const patch = diff((this.scene ?? {}) as unknown as JsonObject, scene as unknown as JsonObject);
    await this.travel(
      async (server) => {
        await server.patch(patch, this.newGesture());
        return server.get();
      },
      (taken) => this.history.found(taken),
    );
  }

  /** Adopts the server's scene. Then applies the unanswered changes `onTheWay` and the queued changes to this scene. */
  private adopt(state: Pick<SessionState, "scene"> & Allowed, onTheWay: Change[]): void {
    for (const [id, layer] of removedBetween(this.scene, state.scene)) this.lost.set(id, layer);
    let scene = state.scene;
    for (const change of [...onTheWay, ...this.queue]) {
      const patch = this.withoutLost(change.patch, scene);
      if (patch !== change.patch) Object.assign(change, { patch, targetsRemovedLayer: true });
      scene = patched(scene, patch);
    }
    this.queue = this.queue.filter(({ patch }) => Object.keys(patch).length > 0);
    this.lostUnanswered = false;
    batch(() => {
      this.allow(state);
      this.show(keptEqual(this.scene, scene));
    });
  }

  /** Puts the scene into the model, also if only `pending` has changed. */
  private show(scene: Scene | null): void {
    const before = this.scene;
    batch(() => {
      this.state.scene.value = scene;
      this.state.pending.value = this.isPending;
      this.events.changed(before);
    });
  }

  private allow({ can_undo, can_redo }: Allowed): void {
    const { canUndo, canRedo } = this.state;
    canUndo.value = can_undo ?? canUndo.peek();
    canRedo.value = can_redo ?? canRedo.peek();
  }

  /** Call after the change is in the history. */
  private accepted(answer: Revision, since: number): void {
    const scene = this.history.accepted;
    if (scene === null) return;
    batch(() => {
      this.allow(answer);
      this.state.pending.value = this.isPending;
      this.events.accepted(answer.revision, since, scene);
    });
  }

  /**
   * Returns the patch without changes of layers that another client has removed. The server would make incomplete
   * layers from these changes.
   */
  private withoutLost(patch: JsonObject, scene: Scene): JsonObject {
    const stray = strayLayers(patch, scene).filter((id) => this.lost.has(id));
    for (const id of stray) this.events.gone(this.lost.get(id) as Layer);
    return withoutLayers(patch, stray);
  }

  private async travel(
    step: (server: SceneServer) => Promise<SessionState>,
    arrived: (scene: Scene) => void,
    refused = (error: Error) => this.events.refused(error),
  ): Promise<void> {
    this.makeHeld();
    const server = this.server;
    if (server === null) {
      this.events.refused(new Error("The session is not open. Try again when the picture is back"));
      return;
    }
    while (this.queue.length > 0) this.sendOldest(server); // so that an undo reverts the latest change
    const since = this.timing.now();
    const before = new Set(this.unanswered); // the result of the step contains these changes
    this.travelling += 1;
    this.show(this.scene);
    try {
      const state = await step(server);
      if (this.server !== server) return;
      this.travelling -= 1;
      arrived(state.scene);
      const after = this.unanswered.filter((change) => !before.has(change));
      this.adopt(state, after);
      this.accepted(state, since);
    } catch (error) {
      if (this.server !== server || error instanceof Disconnected) return;
      this.travelling -= 1;
      refused(error as Error);
      this.show(this.scene);
    }
  }

  private requestFlush(): void {
    if (this.frameRequested) return;
    this.frameRequested = true;
    this.timing.requestFrame(() => {
      this.frameRequested = false;
      this.flush();
    });
  }

  private flush(): void {
    const server = this.server;
    if (server === null) return;
    while (this.queue.length > 0 && this.unanswered.length < this.patchesAtOnce.count) this.sendOldest(server);
  }

  private sendOldest(server: SceneServer): void {
    const change = this.queue.shift();
    if (change === undefined) return;
    this.unanswered.push(change);
    const sentAt = this.timing.now();
    server.patch(change.patch, change.gesture).then(
      (answer) => {
        if (this.server !== server) return;
        this.patchesAtOnce.answered(this.timing.now() - sentAt);
        this.history.changed(change.patch, change.gesture);
        this.answered(change);
        this.accepted(answer, change.since);
      },
      (error: unknown) => {
        if (this.server !== server || error instanceof Disconnected) return;
        if (change.targetsRemovedLayer !== true) this.events.refused(error as Error);
        this.doubtful = true; // the local scene still contains the refused change
        this.answered(change);
      },
    );
  }

  private answered(change: Change): void {
    this.unanswered = this.unanswered.filter((other) => other !== change);
    this.flush();
    if (this.doubtful) this.doubt();
  }

  private doubt(): void {
    const server = this.server;
    this.doubtful = true;
    if (server === null || this.asking || this.differsFromServer) return;
    this.doubtful = false;
    this.asking = true;
    server.get().then(
      (state) => {
        if (this.server !== server) return;
        this.asking = false;
        if (this.differsFromServer)
          this.doubtful = true; // the scene changed during get(): fetch again after the answer to the change
        else {
          this.history.found(state.scene);
          this.adopt(state, []);
        }
        if (this.doubtful) this.doubt();
      },
      (error: unknown) => {
        if (this.server !== server || error instanceof Disconnected) return;
        this.asking = false;
        this.events.refused(error as Error);
      },
    );
  }
}
