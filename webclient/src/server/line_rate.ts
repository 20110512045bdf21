// Measures the bandwidth in bytes per second from the pieces of a frame (protocol/frame.md): the number of bytes after
// the first piece, divided by the time since the first piece arrived.
import type { FrameHeader } from "../generated/frame_header";

/**
 * Fewest bytes after the first piece for a measurement. Fewer bytes may arrive at once from a buffer, and the rate
 * would be too high. If at least this many bytes follow the first piece, the server makes the first piece short.
 */
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
  /** Whether the newest rate belongs to the current frame. If so, each further piece replaces this rate. */
  private isOfNow = false;

  /** Call for each message. `at`: time of arrival in milliseconds. Returns whether the message gave a measurement. */
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

  /**
   * Median of the newest rates; null before the first measurement. A busy page may receive a whole frame at once. Such
   * a rate is too high, but hardly changes the median.
   */
  get bytesPerSecond(): number | null {
    const sorted = [...this.rates].sort((a, b) => a - b);
    return sorted[Math.floor((sorted.length - 1) / 2)] ?? null;
  }
}
