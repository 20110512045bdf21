// Bytes a second of the line, by the pieces of frames (protocol/frame.md): what came after the first piece, by the time
// that it took. Pictures of one piece say nothing; the still behind them has many.
import type { FrameHeader } from "../protocol/frame_header";

/** A whole piece: fewer come out of the buffers at once. */
const FEWEST_BYTES = 64 << 10;
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

  /** A message has come, at `at` milliseconds. */
  arrived({ view, frame, last, payloadBytes }: FrameHeader, at: number): void {
    if (this.now?.view !== view || this.now.frame !== frame) {
      this.now = { view, frame, from: at, bytes: 0 };
      return;
    }
    this.now.bytes += payloadBytes;
    if (!last || this.now.bytes < FEWEST_BYTES) return;
    const took = Math.max(at - this.now.from, 1);
    this.rates = [...this.rates.slice(1 - REMEMBERED), (this.now.bytes * 1000) / took];
  }

  /** The middle one of the last few: where the page was busy, all of a frame seems to come at once. null: not known. */
  get bytesPerSecond(): number | null {
    const sorted = [...this.rates].sort((a, b) => a - b);
    return sorted[Math.floor((sorted.length - 1) / 2)] ?? null;
  }
}
