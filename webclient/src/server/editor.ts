// Local copy of the scene, following the server. Changes apply at once and are sent at most once per animation frame.
import type { Layer, Revision, Scene, SessionState } from "../generated/protocol";
import { applyPatch, composePatches, diff, equal, type Json, type JsonObject } from "../model/merge_patch";
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

export type Step = "undo" | "redo";

export interface EditorEvents {
  /** The scene, canUndo or canRedo has changed. */
  changed(): void;
  /** The server has accepted a change made at `since` (performance.now). `scene` is the result, as `revision`. */
  accepted(revision: number, since: number, scene: Scene): void;
  refused(error: Error): void;
  /** A change of this layer was dropped: another client has removed the layer. */
  gone(layer: Layer): void;
  /** The server cannot show the result of this step. */
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
  /** The scene after the change. */
  scene: Scene;
  /** Targets a removed layer, as already reported: a refusal is not reported again. */
  isVain?: boolean;
}

export class SceneEditor {
  private document: Scene | null = null;
  private server: SceneServer | null = null;
  private queue: Change[] = [];
  private unanswered: Change[] = [];
  private differsFromServer = false;
  /** The local scene may differ from the server's; fetched when nothing is in flight. */
  private doubtful = false;
  private asking = false;
  /** Unanswered undos, redos and followed links. */
  private travelling = 0;
  private patchesAtOnce = new PatchesAtOnce();
  private frameRequested = false;
  private gestures = 0;
  /** Last state of layers that other clients have removed. */
  private readonly lost = new Map<string, Layer>();
  private readonly history = new SceneHistory();
  canUndo = false;
  canRedo = false;

  constructor(
    private readonly events: EditorEvents,
    private readonly timing: Timing,
    private readonly name: string,
  ) {}

  get scene(): Scene | null {
    return this.document;
  }

  get isConnected(): boolean {
    return this.server !== null;
  }

  /** Whether changes are not yet accepted by the server. */
  get isPending(): boolean {
    return this.differsFromServer || this.travelling > 0;
  }

  /** Undo and redo steps for reopening the session with this scene. */
  stepsAround(scene: Scene): Steps {
    return this.history.around(scene);
  }

  /** Returns a gesture name. Changes with the same name are one undo step. */
  newGesture(): string {
    return `${this.name}-${++this.gestures}`;
  }

  change(patch: object, gesture = this.newGesture()): void {
    if (this.document === null) return;
    const part = this.withoutLost(patch as JsonObject, this.document);
    const changed = applyPatch(this.document as unknown as Json, part);
    if (equal(changed, this.document as unknown as Json)) return;
    this.document = changed as unknown as Scene;
    this.differsFromServer = true;
    const newest = this.queue.at(-1);
    const both = newest?.gesture === gesture ? composePatches(newest.patch, part) : null;
    if (newest !== undefined && both !== null) Object.assign(newest, { patch: both, scene: this.document });
    else this.queue.push({ patch: part, gesture, since: this.timing.now(), scene: this.document });
    this.events.changed();
    this.requestFlush();
  }

  /** An automatic change, undone together with the previous step. */
  amend(patch: object): void {
    this.change(patch, `${this.name}-${this.gestures}`);
  }

  /** Replaces the document, as one step. */
  replace(scene: Scene, gesture?: string): void {
    if (this.document === null) return;
    this.change(diff(this.document as unknown as JsonObject, scene as unknown as JsonObject), gesture);
  }

  async undo(): Promise<void> {
    const stuck = (error: Error): void => {
      this.canUndo = false; // until the server says otherwise after another change
      this.events.stuck("undo", error);
    };
    const moved = (scene: Scene): void => this.history.moved("undo", scene);
    await this.travel((server) => server.undo(), moved, stuck);
  }

  async redo(): Promise<void> {
    const stuck = (error: Error): void => {
      this.canRedo = false;
      this.events.stuck("redo", error);
    };
    const moved = (scene: Scene): void => this.history.moved("redo", scene);
    await this.travel((server) => server.redo(), moved, stuck);
  }

  /** Call when a session was opened. Changes made while disconnected are sent as one step. */
  connected(server: SceneServer, state: SessionState): void {
    this.server = server;
    this.patchesAtOnce = new PatchesAtOnce();
    this.unanswered = [];
    this.queue = [];
    this.doubtful = this.asking = false;
    this.travelling = 0;
    const mine = this.document;
    const unsent = this.differsFromServer;
    this.history.found(state.scene);
    this.adopt(state, []);
    if (unsent && mine !== null) this.replace(mine);
  }

  disconnected(): void {
    this.server = null;
    this.unanswered = [];
    this.travelling = 0;
    this.canUndo = this.canRedo = false; // the server keeps the history
    this.events.changed();
  }

  /** Call before `connected` if another scene was chosen to replace the local one. */
  forget(): void {
    this.document = null;
    this.history.forget();
  }

  /** Another client has changed the scene. Changes of this page may be in flight. */
  overheard(scene: Scene): void {
    this.history.found(scene);
    this.adopt({ scene }, this.unanswered);
    this.doubt(); // canUndo and canRedo are now unknown
  }

  /** Like `replace`, but the local scene changes only after the server has accepted the new one. */
  async propose(scene: Scene): Promise<void> {
    const patch = diff((this.document ?? {}) as unknown as JsonObject, scene as unknown as JsonObject);
    await this.travel(
      async (server) => {
        await server.patch(patch, this.newGesture());
        return server.get();
      },
      (taken) => this.history.found(taken),
    );
  }

  /** Takes the server's state and reapplies changes that are in flight or not sent yet. */
  private adopt(state: { scene: Scene; can_undo?: boolean; can_redo?: boolean }, onTheWay: Change[]): void {
    this.canUndo = state.can_undo ?? this.canUndo;
    this.canRedo = state.can_redo ?? this.canRedo;
    for (const [id, layer] of removedBetween(this.document, state.scene)) this.lost.set(id, layer);
    this.document = state.scene;
    for (const change of [...onTheWay, ...this.queue]) {
      const patch = this.withoutLost(change.patch, this.document);
      if (patch !== change.patch) Object.assign(change, { patch, isVain: true });
      this.document = applyPatch(this.document as unknown as Json, patch) as unknown as Scene;
    }
    this.queue = this.queue.filter(({ patch }) => Object.keys(patch).length > 0);
    this.differsFromServer = this.queue.length > 0 || this.unanswered.length > 0;
    this.events.changed();
  }

  /** Removes changes of lost layers: merged into the scene they would be incomplete layers. */
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
    const server = this.server;
    if (server === null) {
      this.events.refused(new Error("There is no open session now; try it again when the picture is back"));
      return;
    }
    while (this.queue.length > 0) this.sendOldest(server); // undo must revert the user's latest change
    const since = this.timing.now();
    const before = new Set(this.unanswered); // the server takes these first
    this.travelling += 1;
    this.events.changed();
    try {
      const state = await step(server);
      if (this.server !== server) return;
      this.travelling -= 1;
      arrived(state.scene);
      const after = this.unanswered.filter((change) => !before.has(change));
      this.adopt(state, after);
      this.events.accepted(state.revision, since, state.scene);
    } catch (error) {
      if (this.server !== server || error instanceof Disconnected) return;
      this.travelling -= 1;
      refused(error as Error);
      this.events.changed();
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
        if (this.canUndo !== answer.can_undo || this.canRedo !== answer.can_redo) {
          this.canUndo = answer.can_undo;
          this.canRedo = answer.can_redo;
          this.events.changed();
        }
        this.events.accepted(answer.revision, change.since, change.scene);
      },
      (error: unknown) => {
        if (this.server !== server || error instanceof Disconnected) return;
        if (change.isVain !== true) this.events.refused(error as Error);
        this.doubtful = true; // the local scene still has the refused change
        this.answered(change);
      },
    );
  }

  private answered(change: Change): void {
    this.unanswered = this.unanswered.filter((other) => other !== change);
    this.differsFromServer = this.unanswered.length > 0 || this.queue.length > 0;
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
          this.doubtful = true; // changed meanwhile: ask again after its answer
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
