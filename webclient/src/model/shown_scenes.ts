// Recent scenes by revision, because the shown picture may be older than the newest scene.
import type { Scene } from "../generated/protocol";

interface Known {
  revision: number;
  scene: Scene;
}

export class ShownScenes {
  private known: Known[] = [];

  /** Forgets all scenes. Call for a new session: revisions of different sessions are not comparable. */
  clear(): void {
    this.known = [];
  }

  taken(revision: number, scene: Scene): void {
    const others = this.known.filter((one) => one.revision !== revision);
    this.known = [...others, { revision, scene }].sort((a, b) => a.revision - b.revision);
  }

  /** Returns the newest scene up to `revision`. Drops all scenes before it, because no later picture shows them. */
  of(revision: number): Scene | null {
    const newest = this.known.findLastIndex((one) => one.revision <= revision);
    if (newest > 0) this.known = this.known.slice(newest);
    return newest < 0 ? null : (this.known[0]?.scene ?? null);
  }
}
