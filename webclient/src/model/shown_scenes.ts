// Scenes by revision. A picture lags behind the newest scene: its camera and dataset are those of its own revision.
import { complete, type FullCamera } from "./camera";
import type { Scene } from "../generated/protocol";

interface Known {
  revision: number;
  scene: Scene;
}

export class ShownScenes {
  /** In ascending order of revision. */
  private known: Known[] = [];

  /** For a new session: revisions of another session are not comparable. */
  clear(): void {
    this.known = [];
  }

  taken(revision: number, scene: Scene): void {
    const others = this.known.filter((one) => one.revision !== revision);
    this.known = [...others, { revision, scene }].sort((a, b) => a.revision - b.revision);
  }

  /** Scene of the shown picture; null if unknown. Drops older scenes: no picture of them follows. */
  of(revision: number): Scene | null {
    const newest = this.known.findLastIndex((one) => one.revision <= revision);
    if (newest > 0) this.known = this.known.slice(newest);
    return newest < 0 ? null : (this.known[0]?.scene ?? null);
  }

  /** null if the scene is unknown or has no camera. */
  cameraOf(revision: number): FullCamera | null {
    const camera = this.of(revision)?.camera;
    return camera ? complete(camera) : null;
  }
}
