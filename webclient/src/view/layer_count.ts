// Number of depth peeling layers to draw. Occlusion queries tell only after a picture which layers were empty, so each
// picture uses the result of the previous one.

export const MOST_LAYERS = 32; // also the server's limit; further layers are dropped
export const MOST_MOVING_LAYERS = 8;
/** Empty layers to draw in the next picture, because a moving camera may reveal more layers. */
const SPARE = 2;

export class LayerCount {
  private wanted = MOST_MOVING_LAYERS;

  next(moving: boolean): number {
    return Math.min(this.wanted, moving ? MOST_MOVING_LAYERS : MOST_LAYERS);
  }

  /**
   * Takes the query results of a picture. `filled`: whether each layer had any fragments. Returns whether more layers
   * would have fragments.
   */
  heard(filled: readonly boolean[]): boolean {
    const empty = filled.indexOf(false);
    this.wanted = empty < 0 ? Math.min(2 * filled.length, MOST_LAYERS) : Math.min(empty + SPARE, MOST_LAYERS);
    return empty < 0 && filled.length < MOST_LAYERS;
  }
}
