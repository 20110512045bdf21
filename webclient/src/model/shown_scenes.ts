// Recent scenes by revision. The shown picture may be older than the newest scene. Therefore the revision of the
// picture is used to look up the camera and the dataset of the picture.
import { complete, type FullCamera } from "./camera";
import type { Scene } from "../generated/protocol";

interface Known {
  revision: number;
  scene: Scene;
}

export class ShownScenes {
  /** Scenes in ascending order of revision. */
  private known: Known[] = [];

  /** Forgets all scenes. Call for a new session: revisions of different sessions are not comparable. */
  clear(): void {
    this.known = [];
  }

  taken(revision: number, scene: Scene): void {
    const others = this.known.filter((one) => one.revision !== revision);
    this.known = [...others, { revision, scene }].sort((a, b) => a.revision - b.revision);
  }

  /**
   * Returns the newest scene with a revision up to `revision`, or null if no such scene is known. Drops all older
   * scenes, because no later picture shows them.
   */
  of(revision: number): Scene | null {
    const newest = this.known.findLastIndex((one) => one.revision <= revision);
    if (newest > 0) this.known = this.known.slice(newest);
    return newest < 0 ? null : (this.known[0]?.scene ?? null);
  }

  /** Returns the camera of the scene at `revision`. null if the scene is unknown or has no camera. */
  cameraOf(revision: number): FullCamera | null {
    const camera = this.of(revision)?.camera;
    return camera ? complete(camera) : null;
  }
}
