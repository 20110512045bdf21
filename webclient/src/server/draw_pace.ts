// Measures the time from a redraw request to drawn polygons. WebGL calls return before the drawing ends, but the next
// animation frame starts only after it.

const REMEMBERED = 8;
/** Number of measurements needed for a result. The first ones include shader compilation. */
const FEWEST = 4;

export class DrawPace {
  private waits: number[] = [];

  drawn(requestedAt: number, at: number): void {
    this.waits = [...this.waits.slice(1 - REMEMBERED), at - requestedAt];
  }

  /** Median time from request to drawn polygons in milliseconds; null if not measured. */
  get milliseconds(): number | null {
    if (this.waits.length < FEWEST) return null;
    const sorted = [...this.waits].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? null;
  }
}
