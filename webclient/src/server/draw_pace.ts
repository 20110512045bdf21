// How soon the browser draws polygons after it is asked to. Its calls return at once, whatever draws; but the next
// animation frame does not come before the last is drawn.

const REMEMBERED = 8;
/** The first of them wait for programs to be compiled. */
const FEWEST = 4;

export class DrawPace {
  private waits: number[] = [];

  drawn(requestedAt: number, at: number): void {
    this.waits = [...this.waits.slice(1 - REMEMBERED), at - requestedAt];
  }

  /** Milliseconds between the wish and the picture; null where it is not known. */
  get milliseconds(): number | null {
    if (this.waits.length < FEWEST) return null;
    const sorted = [...this.waits].sort((a, b) => a - b);
    return sorted[Math.floor(sorted.length / 2)] ?? null;
  }
}
