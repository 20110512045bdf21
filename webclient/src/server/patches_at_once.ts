// Number of scene changes that may wait for an answer: the number of animation frames in one round trip. With this
// number, no change waits for the answer to the previous change. More changes would queue on the server. Later changes
// are merged until they can be sent.

const FRAME_MS = 16;
/** Lower limit, enough for a local server. */
const LEAST = 2;
/** Upper limit, enough for answers that take half a second. */
const MOST = 32;
const REMEMBERED = 16;

export class PatchesAtOnce {
  private answers: number[] = [];

  /** Call when a change was answered. `took`: milliseconds between sending and answer. */
  answered(took: number): void {
    this.answers = [...this.answers.slice(1 - REMEMBERED), took];
  }

  /**
   * Number of changes that may wait for an answer. Computed from the fastest recent answer, which did not wait on the
   * server.
   */
  get count(): number {
    if (this.answers.length === 0) return LEAST;
    return Math.min(MOST, LEAST + Math.floor(Math.min(...this.answers) / FRAME_MS));
  }
}
