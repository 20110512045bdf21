// Number of changes that may be in flight to the server: one per animation frame within a round trip, so that none
// waits for the previous answer. More would queue on the server; newer changes are merged meanwhile.

const FRAME_MS = 16;
/** Enough for a local server. */
const LEAST = 2;
/** Enough for answers that take half a second. */
const MOST = 32;
const REMEMBERED = 16;

export class PatchesAtOnce {
  private answers: number[] = [];

  /** `took`: milliseconds until a change was answered. */
  answered(took: number): void {
    this.answers = [...this.answers.slice(1 - REMEMBERED), took];
  }

  /** Uses the fastest answer, which has no waiting time on the server. */
  get count(): number {
    if (this.answers.length === 0) return LEAST;
    return Math.min(MOST, LEAST + Math.floor(Math.min(...this.answers) / FRAME_MS));
  }
}
