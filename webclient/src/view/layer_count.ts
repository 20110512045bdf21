// How many layers to draw. WebGL tells only after the picture whether anything was in a layer, so the next picture goes
// by what the last one had.

export const MOST_LAYERS = 32; // as the server has it: what is behind so many is not seen
export const MOST_MOVING_LAYERS = 8;
/** What a camera that turns may bring to light from one picture to the next. */
const SPARE = 2;

export class LayerCount {
  private wanted = MOST_MOVING_LAYERS;

  next(moving: boolean): number {
    return Math.min(this.wanted, moving ? MOST_MOVING_LAYERS : MOST_LAYERS);
  }

  /** Of each layer that was drawn, whether anything was in it. True where there may be more than that. */
  heard(filled: readonly boolean[]): boolean {
    const empty = filled.indexOf(false);
    this.wanted = empty < 0 ? Math.min(2 * filled.length, MOST_LAYERS) : Math.min(empty + SPARE, MOST_LAYERS);
    return empty < 0 && filled.length < MOST_LAYERS;
  }
}
