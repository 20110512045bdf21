// Joins the pieces of long messages, which the server splits because proxies reject long messages (protocol/frame.md).
import { FRAME_HEADER_BYTES, writeFrameHeader, type FrameHeader } from "../generated/frame_header";

interface Begun {
  frame: number;
  flags: number;
  message: ArrayBuffer;
  /** Payload bytes received so far. */
  arrived: number;
}

/** Joins the pieces of the frames of one view. */
export class Pieces {
  private begun: Begun | null = null;

  /** Adds a piece. Returns the whole message after the last piece, else null. Throws Error if a piece is missing. */
  add(header: FrameHeader, message: ArrayBuffer): ArrayBuffer | null {
    if (header.payloadBytes === header.wholeBytes) {
      this.begun = null;
      return message;
    }
    if (header.pieceOffset === 0) this.begin(header);
    const { begun } = this;
    if (begun === null || begun.frame !== header.frame || begun.arrived !== header.pieceOffset) {
      this.begun = null;
      throw new Error(`A piece of frame ${header.frame} is missing. Reload the page`);
    }
    new Uint8Array(begun.message, FRAME_HEADER_BYTES + begun.arrived).set(new Uint8Array(message, FRAME_HEADER_BYTES));
    begun.arrived += header.payloadBytes;
    begun.flags |= header.flags;
    if (begun.arrived < header.wholeBytes) return null;
    this.begun = null;
    writeFrameHeader({ ...header, flags: begun.flags, payloadBytes: header.wholeBytes, pieceOffset: 0 }, begun.message);
    return begun.message;
  }

  clear(): void {
    this.begun = null;
  }

  private begin({ frame, flags, wholeBytes }: FrameHeader): void {
    this.begun = { frame, flags, message: new ArrayBuffer(FRAME_HEADER_BYTES + wholeBytes), arrived: 0 };
  }
}
