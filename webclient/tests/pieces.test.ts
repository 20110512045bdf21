import { describe, expect, test } from "vitest";
import { readFrameHeader, FRAME_HEADER_BYTES } from "../src/generated/frame_header";
import { Pieces } from "../src/server/pieces";
import { frameBytes } from "./frames";

const FIRST = 4;
const LAST = 2;

interface Piece {
  frame?: number;
  flags?: number;
  offset: number;
  bytes: number[];
  whole: number;
}

const add = (pieces: Pieces, { bytes, ...fields }: Piece): ArrayBuffer | null => {
  const message = frameBytes({ flags: 0, ...fields }, Uint8Array.from(bytes));
  return pieces.add(readFrameHeader(message), message);
};

describe("pieces", () => {
  test("a whole message is given on as it is", () => {
    const message = frameBytes({}, Uint8Array.of(1, 2));
    expect(new Pieces().add(readFrameHeader(message), message)).toBe(message);
  });

  test("make one message with the flags of the first and the last", () => {
    const pieces = new Pieces();
    expect(add(pieces, { offset: 0, bytes: [1, 2], whole: 5, flags: FIRST })).toBeNull();
    expect(add(pieces, { offset: 2, bytes: [3, 4], whole: 5 })).toBeNull();
    const whole = add(pieces, { offset: 4, bytes: [5], whole: 5, flags: LAST }) as ArrayBuffer;
    expect([...new Uint8Array(whole, FRAME_HEADER_BYTES)]).toEqual([1, 2, 3, 4, 5]);
    expect(readFrameHeader(whole)).toMatchObject({
      firstOfFrame: true,
      lastOfFrame: true,
      payloadBytes: 5,
      pieceOffset: 0,
    });
  });

  test("half a frame gives way to a newer one", () => {
    const pieces = new Pieces();
    expect(add(pieces, { offset: 0, bytes: [1, 2], whole: 4, frame: 1 })).toBeNull();
    expect(add(pieces, { offset: 0, bytes: [5, 6], whole: 4, frame: 2 })).toBeNull();
    const whole = add(pieces, { offset: 2, bytes: [7, 8], whole: 4, frame: 2 }) as ArrayBuffer;
    expect([...new Uint8Array(whole, FRAME_HEADER_BYTES)]).toEqual([5, 6, 7, 8]);
  });

  test.each([
    { name: "the first", lost: { offset: 2, bytes: [3], whole: 4, frame: 1 } },
    { name: "one between", lost: { offset: 3, bytes: [4], whole: 4, frame: 2 } },
    { name: "the first of another frame", lost: { offset: 2, bytes: [3], whole: 4, frame: 3 } },
  ])("$name is missing", ({ lost }) => {
    const pieces = new Pieces();
    if (lost.frame > 1) add(pieces, { offset: 0, bytes: [1, 2], whole: 4, frame: 2 });
    expect(() => add(pieces, lost)).toThrow("is missing");
  });
});
