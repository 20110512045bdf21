// Chooses the number of layers of depth peeling from occlusion queries of the previous picture. The results of queries
// are not available while the same picture is drawn.

export const MOST_LAYERS = 32; // also the server's limit; further layers are dropped
export const MOST_MOVING_LAYERS = 8;
/** Layers in addition to the filled layers, because a moving camera may reveal more layers. */
const SPARE = 2;

export class LayerCount {
  private wanted = MOST_MOVING_LAYERS;

  next(moving: boolean): number {
    return Math.min(this.wanted, moving ? MOST_MOVING_LAYERS : MOST_LAYERS);
  }

  /** `filled`: whether each layer had any fragments. Returns whether a picture with more layers may show more. */
  heard(filled: readonly boolean[]): boolean {
    const empty = filled.indexOf(false);
    this.wanted = empty < 0 ? Math.min(2 * filled.length, MOST_LAYERS) : Math.min(empty + SPARE, MOST_LAYERS);
    return empty < 0 && filled.length < MOST_LAYERS;
  }
}
