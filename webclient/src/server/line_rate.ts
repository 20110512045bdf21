// Bytes a second of the line, by the pieces of frames (protocol/frame.md): what came after the first piece, by the time
// that it took. Moving pictures of one piece say nothing; the still behind them is longer.
import type { FrameHeader } from "./frame_header";

/** Fewer come out of the buffers at once. Frames that are longer by a short piece begin with one. */
const FEWEST_BYTES = 32 << 10;
const REMEMBERED = 5;

interface Measured {
  view: number;
  frame: number;
  from: number;
  bytes: number;
}

export class LineRate {
  private now: Measured | null = null;
  private rates: number[] = [];
  /** Whether the newest of them is of the frame that is on its way: it is taken again with each piece. */
  private isOfNow = false;

  /** A message has come, at `at` milliseconds. Returns whether it says something about the rate. */
  arrived({ view, frame, payloadBytes }: FrameHeader, at: number): boolean {
    if (this.now?.view !== view || this.now.frame !== frame) {
      this.now = { view, frame, from: at, bytes: 0 };
      this.isOfNow = false;
      return false;
    }
    this.now.bytes += payloadBytes;
    if (this.now.bytes < FEWEST_BYTES) return false;
    const took = Math.max(at - this.now.from, 1);
    const others = this.isOfNow ? this.rates.slice(0, -1) : this.rates.slice(1 - REMEMBERED);
    this.rates = [...others, (this.now.bytes * 1000) / took];
    this.isOfNow = true;
    return true;
  }

  /** The middle one of the last few: where the page was busy, all of a frame seems to come at once. null: not known. */
  get bytesPerSecond(): number | null {
    const sorted = [...this.rates].sort((a, b) => a - b);
    return sorted[Math.floor((sorted.length - 1) / 2)] ?? null;
  }
}
