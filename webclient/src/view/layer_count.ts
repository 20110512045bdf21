// Number of layers to draw. Whether a layer was empty is known only after the picture, so the next picture uses the
// count of the last one.

export const MOST_LAYERS = 32; // same as on the server; layers beyond are dropped
export const MOST_MOVING_LAYERS = 8;
/** Additional layers that a moving camera may reveal in the next picture. */
const SPARE = 2;

export class LayerCount {
  private wanted = MOST_MOVING_LAYERS;

  next(moving: boolean): number {
    return Math.min(this.wanted, moving ? MOST_MOVING_LAYERS : MOST_LAYERS);
  }

  /** `filled`: whether each drawn layer had any pixels. Returns true if there may be more layers. */
  heard(filled: readonly boolean[]): boolean {
    const empty = filled.indexOf(false);
    this.wanted = empty < 0 ? Math.min(2 * filled.length, MOST_LAYERS) : Math.min(empty + SPARE, MOST_LAYERS);
    return empty < 0 && filled.length < MOST_LAYERS;
  }
}
