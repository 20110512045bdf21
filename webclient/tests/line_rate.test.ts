import { describe, expect, test } from "vitest";
import { decodeHeader } from "../src/protocol/frame_header";
import { LineRate } from "../src/session/line_rate";
import { frameBytes } from "./frames";

const FIRST = 4;
const LAST = 2;
const PIECE = 64 << 10;

/** A frame of so many pieces, one every `every` milliseconds. */
function arrive(rate: LineRate, frame: number, pieces: number, every: number): void {
  for (let i = 0; i < pieces; i += 1) {
    const flags = (i === 0 ? FIRST : 0) | (i === pieces - 1 ? LAST : 0);
    const fields = { frame, flags, offset: i * PIECE, whole: pieces * PIECE };
    rate.arrived(decodeHeader(frameBytes(fields, new Uint8Array(PIECE))), 1000 * frame + every * i);
  }
}

describe("rate of the line", () => {
  test("is that of the pieces after the first", () => {
    const rate = new LineRate();
    expect(rate.bytesPerSecond).toBeNull();
    arrive(rate, 1, 8, 52);
    expect(rate.bytesPerSecond).toBeCloseTo((PIECE * 1000) / 52);
  });

  test("pictures of one piece say nothing", () => {
    const rate = new LineRate();
    for (let frame = 1; frame < 9; frame += 1) arrive(rate, frame, 1, 1);
    expect(rate.bytesPerSecond).toBeNull();
  });

  test("one frame that came out of the buffers at once does not count", () => {
    const rate = new LineRate();
    arrive(rate, 1, 8, 50);
    arrive(rate, 2, 8, 0);
    arrive(rate, 3, 8, 50);
    expect(rate.bytesPerSecond).toBeCloseTo((PIECE * 1000) / 50);
  });

  test("a line that has become slower is seen", () => {
    const rate = new LineRate();
    for (let frame = 1; frame < 6; frame += 1) arrive(rate, frame, 8, 1);
    for (let frame = 6; frame < 11; frame += 1) arrive(rate, frame, 8, 100);
    expect(rate.bytesPerSecond).toBeCloseTo((PIECE * 1000) / 100);
  });

  test("a frame that gave way to a newer one is not counted", () => {
    const rate = new LineRate();
    const piece = (frame: number, flags: number): void =>
      rate.arrived(decodeHeader(frameBytes({ frame, flags, whole: 9 * PIECE }, new Uint8Array(PIECE))), 10 * frame);
    for (let i = 0; i < 5; i += 1) piece(1, FIRST);
    piece(2, FIRST | LAST);
    expect(rate.bytesPerSecond).toBeNull();
  });
});
