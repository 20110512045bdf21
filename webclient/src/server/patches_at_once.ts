// How many changes may be on their way to the server: one an animation frame for as long as an answer takes, so that none
// waits for the answer to the one before. More would queue on the server; newer changes are merged meanwhile.

const FRAME_MS = 16;
/** Those that a server beside the page has in its hands. */
const LEAST = 2;
/** Of an answer in half a second. */
const MOST = 32;
const REMEMBERED = 16;

export class PatchesAtOnce {
  private answers: number[] = [];

  /** Milliseconds until a change was answered. */
  answered(took: number): void {
    this.answers = [...this.answers.slice(1 - REMEMBERED), took];
  }

  /** The soonest answer is the line's own time: what waited on the server does not ask for more. */
  get count(): number {
    if (this.answers.length === 0) return LEAST;
    return Math.min(MOST, LEAST + Math.floor(Math.min(...this.answers) / FRAME_MS));
  }
}
