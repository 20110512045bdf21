// Measures the time from a redraw request to drawn polygons. During repeated redraws, this time contains the drawing
// time, because the next animation frame starts only after the GPU has finished.

const REMEMBERED = 8;
/** Number of measurements needed for a result, because the first measurements include the compilation of shaders. */
const FEWEST = 4;

export class DrawPace {
  private waits: number[] = [];

  drawn(requestedAt: number, at: number): void {
    this.waits = [...this.waits.slice(1 - REMEMBERED), at - requestedAt];
  }

  forget(): void {
    this.waits = [];
  }

  get milliseconds(): number | null {
    if (this.waits.length < FEWEST) return null;
    const sorted = [...this.waits].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? null;
  }
}
