// Scenes by revision. A picture is a moment behind the hand: its camera and its dataset are those of its own revision.
import { complete, type FullCamera } from "./camera";
import type { Scene } from "../generated/protocol";

interface Known {
  revision: number;
  scene: Scene;
}

export class ShownScenes {
  /** Ascending. */
  private known: Known[] = [];

  /** Revisions of another session mean nothing here. */
  clear(): void {
    this.known = [];
  }

  taken(revision: number, scene: Scene): void {
    const others = this.known.filter((one) => one.revision !== revision);
    this.known = [...others, { revision, scene }].sort((a, b) => a.revision - b.revision);
  }

  /** Of a picture that is shown; null where it is not known. Older ones are forgotten: no picture of them follows. */
  of(revision: number): Scene | null {
    const newest = this.known.findLastIndex((one) => one.revision <= revision);
    if (newest > 0) this.known = this.known.slice(newest);
    return newest < 0 ? null : (this.known[0]?.scene ?? null);
  }

  /** null also where the scene has none. */
  cameraOf(revision: number): FullCamera | null {
    const camera = this.of(revision)?.camera;
    return camera ? complete(camera) : null;
  }
}
