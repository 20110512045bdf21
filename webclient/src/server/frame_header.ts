// The 80-byte header of every binary message (protocol/frame.md).

export const HEADER_BYTES = 80;
export const KIND_IMAGE = 1;
export const KIND_GEOMETRY = 2;

export interface FrameHeader {
  kind: number;
  flags: number;
  still: boolean;
  last: boolean;
  first: boolean;
  view: number;
  frame: number;
  revision: number;
  width: number;
  height: number;
  time: number;
  waitMs: number;
  extractMs: number;
  drawMs: number;
  encodeMs: number;
  triangles: number;
  /** Payload of this message. */
  payloadBytes: number;
  /** Payload of the whole picture or batch. */
  wholeBytes: number;
  /** Offset of this message's payload in the whole. */
  pieceOffset: number;
}

const MAGIC = 0x4c454943; // "CIEL", little-endian
const VERSION = 2;

/** Throws Error when the message is not a valid frame. */
export function decodeHeader(message: ArrayBuffer): FrameHeader {
  if (message.byteLength < HEADER_BYTES) {
    throw new Error(`A frame of ${message.byteLength} bytes is shorter than its header`);
  }
  const view = new DataView(message);
  if (view.getUint32(0, true) !== MAGIC) throw new Error("A binary message is not a CIEL frame");
  if (view.getUint8(4) !== VERSION) {
    throw new Error(
      `The server sends frames of version ${view.getUint8(4)}; this page knows version ${VERSION}. Reload it`,
    );
  }
  const flags = view.getUint16(6, true);
  const header = {
    kind: view.getUint8(5),
    flags,
    still: (flags & 1) !== 0,
    last: (flags & 2) !== 0,
    first: (flags & 4) !== 0,
    view: view.getUint32(8, true),
    frame: view.getUint32(12, true),
    revision: Number(view.getBigUint64(16, true)),
    width: view.getUint32(24, true),
    height: view.getUint32(28, true),
    time: view.getFloat64(32, true),
    waitMs: view.getFloat32(40, true),
    extractMs: view.getFloat32(44, true),
    drawMs: view.getFloat32(48, true),
    encodeMs: view.getFloat32(52, true),
    triangles: view.getUint32(56, true),
    payloadBytes: view.getUint32(60, true),
    wholeBytes: view.getUint32(64, true),
    pieceOffset: view.getUint32(68, true),
  };
  if (header.payloadBytes !== message.byteLength - HEADER_BYTES) {
    throw new Error(`A frame announces ${header.payloadBytes} bytes and brings ${message.byteLength - HEADER_BYTES}`);
  }
  if (header.pieceOffset + header.payloadBytes > header.wholeBytes) {
    throw new Error(`A piece of a frame ends behind its ${header.wholeBytes} bytes`);
  }
  return header;
}

/** Completes the header of a reassembled message, which is a copy of its first piece's header. */
export function setWhole(message: ArrayBuffer, flags: number): void {
  const view = new DataView(message);
  view.setUint16(6, flags, true);
  view.setUint32(60, message.byteLength - HEADER_BYTES, true);
}
