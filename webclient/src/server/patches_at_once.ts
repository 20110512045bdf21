// Number of scene changes that may wait for an answer: the number of animation frames in one round trip. Further
// changes would queue on the server, so they are merged until they can be sent.

const FRAME_MS = 16;
/** Lower limit, enough for a local server. */
const LEAST = 2;
/** Upper limit, enough for answers that take half a second. */
const MOST = 32;
const REMEMBERED = 16;

export class PatchesAtOnce {
  private answers: number[] = [];

  /** `took`: milliseconds between sending and answer. */
  answered(took: number): void {
    this.answers = [...this.answers.slice(1 - REMEMBERED), took];
  }

  /** The fastest recent answer gives the round trip, because it did not wait in a queue on the server. */
  get count(): number {
    if (this.answers.length === 0) return LEAST;
    return Math.min(MOST, LEAST + Math.floor(Math.min(...this.answers) / FRAME_MS));
  }
}
