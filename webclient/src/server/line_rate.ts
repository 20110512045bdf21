// Line rate in bytes per second, from the pieces of a frame (protocol/frame.md): bytes after the first piece, divided
// by the time since it. Moving pictures of one piece give no measurement; the still after them is longer.
import type { FrameHeader } from "../generated/frame_header";

/** Fewer bytes may arrive at once from buffers. Frames longer than this by a short piece begin with one. */
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
  /** Whether the newest rate is of the current frame; each piece then updates it. */
  private isOfNow = false;

  /** Call for each message; `at` in milliseconds. Returns whether it gave a measurement. */
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

  /** Median of the last few rates, since a busy page sees a whole frame arrive at once. null: unknown. */
  get bytesPerSecond(): number | null {
    const sorted = [...this.rates].sort((a, b) => a - b);
    return sorted[Math.floor((sorted.length - 1) / 2)] ?? null;
  }
}
