// Time from a redraw request to the drawn polygons. WebGL calls return at once, but the next animation frame waits
// until the last one is drawn.

const REMEMBERED = 8;
/** Measurements needed for a result: the first ones include shader compilation. */
const FEWEST = 4;

export class DrawPace {
  private waits: number[] = [];

  drawn(requestedAt: number, at: number): void {
    this.waits = [...this.waits.slice(1 - REMEMBERED), at - requestedAt];
  }

  /** Median milliseconds from request to picture; null if unknown. */
  get milliseconds(): number | null {
    if (this.waits.length < FEWEST) return null;
    const sorted = [...this.waits].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? null;
  }
}
