// The scene as this page sees it: changed at once, sent at most once per animation frame, agreed with the server's.
import type { Revision, Scene, SessionState } from "../generated/protocol";
import { applyPatch, composePatches, diff, equal, type Json, type JsonObject } from "../protocol/merge_patch";
import { Disconnected } from "../protocol/rpc";

export interface SceneServer {
  patch(patch: JsonObject, gesture: string): Promise<Revision>;
  undo(): Promise<SessionState>;
  redo(): Promise<SessionState>;
  get(): Promise<SessionState>;
}

export interface EditorEvents {
  /** The scene or what can be undone differs. */
  changed(): void;
  /** The server has taken the changes made since `since` (performance.now) as this revision. */
  accepted(revision: number, since: number): void;
  refused(error: Error): void;
}

export interface Timing {
  now(): number;
  requestFrame(callback: () => void): void;
}

interface Change {
  patch: JsonObject;
  gesture: string;
  since: number;
}

/** More would queue on the server; newer changes are merged here meanwhile. */
const MAX_UNANSWERED = 2;

export class SceneEditor {
  private document: Scene | null = null;
  private server: SceneServer | null = null;
  private queue: Change[] = [];
  private unanswered = 0;
  private differsFromServer = false;
  private frameRequested = false;
  private gestures = 0;
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

  /** Whether the server has not taken everything yet. */
  get isPending(): boolean {
    return this.differsFromServer;
  }

  /** Changes that share the name are one undo step. */
  newGesture(): string {
    return `${this.name}-${++this.gestures}`;
  }

  change(patch: object, gesture = this.newGesture()): void {
    if (this.document === null) return;
    const part = patch as JsonObject;
    const changed = applyPatch(this.document as unknown as Json, part);
    if (equal(changed, this.document as unknown as Json)) return;
    this.document = changed as unknown as Scene;
    this.differsFromServer = true;
    const newest = this.queue.at(-1);
    const both = newest?.gesture === gesture ? composePatches(newest.patch, part) : null;
    if (newest !== undefined && both !== null) newest.patch = both;
    else this.queue.push({ patch: part, gesture, since: this.timing.now() });
    this.events.changed();
    this.requestFlush();
  }

  /** Changes into another document, as one step. */
  replace(scene: Scene, gesture?: string): void {
    if (this.document === null) return;
    this.change(diff(this.document as unknown as JsonObject, scene as unknown as JsonObject), gesture);
  }

  async undo(): Promise<void> {
    await this.travel((server) => server.undo());
  }

  async redo(): Promise<void> {
    await this.travel((server) => server.redo());
  }

  /** What a session that was just opened holds. Changes that were made while there was none are sent as one step. */
  connected(server: SceneServer, state: SessionState): void {
    this.server = server;
    this.unanswered = 0;
    this.queue = [];
    const mine = this.document;
    const unsent = this.differsFromServer;
    this.adopt(state);
    if (unsent && mine !== null) this.replace(mine);
  }

  disconnected(): void {
    this.server = null;
    this.unanswered = 0;
  }

  /** The server's own word, after an undo or from another client of the session. Changes not yet sent stay on top. */
  adopt(state: { scene: Scene; can_undo?: boolean; can_redo?: boolean }): void {
    this.canUndo = state.can_undo ?? this.canUndo;
    this.canRedo = state.can_redo ?? this.canRedo;
    this.document = state.scene;
    for (const { patch } of this.queue) {
      this.document = applyPatch(this.document as unknown as Json, patch) as unknown as Scene;
    }
    this.differsFromServer = this.queue.length > 0 || this.unanswered > 0;
    this.events.changed();
  }

  private async travel(step: (server: SceneServer) => Promise<SessionState>): Promise<void> {
    const server = this.server;
    if (server === null) return;
    while (this.queue.length > 0) this.sendOldest(server); // an undo takes back what the hand did last
    const since = this.timing.now();
    try {
      const state = await step(server);
      if (this.server !== server) return;
      this.adopt(state);
      this.events.accepted(state.revision, since);
    } catch (error) {
      if (!(error instanceof Disconnected)) this.events.refused(error as Error);
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
    while (this.queue.length > 0 && this.unanswered < MAX_UNANSWERED) this.sendOldest(server);
  }

  private sendOldest(server: SceneServer): void {
    const change = this.queue.shift();
    if (change === undefined) return;
    this.unanswered += 1;
    server.patch(change.patch, change.gesture).then(
      (answer) => {
        if (this.server !== server) return;
        this.answered();
        if (this.canUndo !== answer.can_undo || this.canRedo !== answer.can_redo) {
          this.canUndo = answer.can_undo;
          this.canRedo = answer.can_redo;
          this.events.changed();
        }
        this.events.accepted(answer.revision, change.since);
      },
      (error: unknown) => {
        if (this.server !== server || error instanceof Disconnected) return;
        this.answered();
        this.events.refused(error as Error);
        void this.resynchronise(server);
      },
    );
  }

  private answered(): void {
    this.unanswered -= 1;
    this.differsFromServer = this.unanswered > 0 || this.queue.length > 0;
    this.flush();
  }

  // A refused change stands in the local scene only.
  private async resynchronise(server: SceneServer): Promise<void> {
    try {
      const state = await server.get();
      if (this.server === server) this.adopt(state);
    } catch (error) {
      if (!(error instanceof Disconnected)) this.events.refused(error as Error);
    }
  }
}
