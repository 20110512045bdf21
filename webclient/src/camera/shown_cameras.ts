// Cameras by the revision of the scene that has them: a picture is a moment behind the hand, and what lies over it must
// stand where the picture has it.
import type { Camera } from "../generated/protocol";
import { complete, type FullCamera } from "./camera";

interface Known {
  revision: number;
  /** null: the scene has none. */
  camera: FullCamera | null;
}

export class ShownCameras {
  /** Ascending. */
  private known: Known[] = [];

  /** Revisions of another session mean nothing here. */
  clear(): void {
    this.known = [];
  }

  taken(revision: number, camera: Camera | null | undefined): void {
    const others = this.known.filter((one) => one.revision !== revision);
    this.known = [...others, { revision, camera: camera ? complete(camera) : null }].sort(
      (a, b) => a.revision - b.revision,
    );
  }

  /** Of a picture that is shown; null where it is not known. Older ones are forgotten: no picture of them follows. */
  of(revision: number): FullCamera | null {
    const newest = this.known.findLastIndex((one) => one.revision <= revision);
    if (newest > 0) this.known = this.known.slice(newest);
    return newest < 0 ? null : (this.known[0]?.camera ?? null);
  }
}
