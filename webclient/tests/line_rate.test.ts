import { describe, expect, test } from "vitest";
import { readFrameHeader } from "../src/generated/frame_header";
import { LineRate } from "../src/server/line_rate";
import { frameBytes } from "./frames";

const FIRST = 4;
const LAST = 2;
const PIECE = 64 << 10;

/** Feeds a frame of `pieces` pieces, one every `every` milliseconds. */
function arrive(rate: LineRate, frame: number, pieces: number, every: number, length = PIECE): void {
  for (let i = 0; i < pieces; i += 1) {
    const flags = (i === 0 ? FIRST : 0) | (i === pieces - 1 ? LAST : 0);
    const fields = { frame, flags, offset: i * length, whole: pieces * length };
    rate.arrived(readFrameHeader(frameBytes(fields, new Uint8Array(length))), 1000 * frame + every * i);
  }
}

describe("rate of the line", () => {
  test("is that of the pieces after the first", () => {
    const rate = new LineRate();
    expect(rate.bytesPerSecond).toBeNull();
    arrive(rate, 1, 8, 52);
    expect(rate.bytesPerSecond).toBeCloseTo((PIECE * 1000) / 52);
  });

  test("a still of the demo on 10 Mbit/s is enough, its first piece being short", () => {
    const rate = new LineRate();
    const lengths = [4 << 10, 64 << 10, 32 << 10];
    let at = 0;
    lengths.forEach((length, i) => {
      at += length / 1250;
      const flags = [FIRST, 0, LAST][i] ?? 0;
      rate.arrived(readFrameHeader(frameBytes({ flags, whole: 100 << 10 }, new Uint8Array(length))), at);
    });
    expect(rate.bytesPerSecond).toBeCloseTo(1.25e6);
  });

  test("what one delivery of the buffers may hold says nothing", () => {
    const rate = new LineRate();
    for (let frame = 1; frame < 9; frame += 1) arrive(rate, frame, 1, 1);
    arrive(rate, 9, 2, 1, 16 << 10);
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

  test("a long frame tells long before its end, and once, however many its pieces", () => {
    const rate = new LineRate();
    for (let frame = 1; frame < 6; frame += 1) arrive(rate, frame, 8, 1);
    const piece = (frame: number, at: number): boolean =>
      rate.arrived(readFrameHeader(frameBytes({ frame, flags: 0, whole: 999 * PIECE }, new Uint8Array(PIECE))), at);
    expect(piece(6, 6000)).toBe(false);
    for (let i = 1; i < 9; i += 1) expect(piece(6, 6000 + 100 * i)).toBe(true);
    expect(rate.bytesPerSecond).toBeCloseTo(PIECE * 1000);
    piece(7, 7000); // frame 7 begins before all pieces of frame 6 have arrived
    piece(7, 7100);
    arrive(rate, 8, 8, 100);
    expect(rate.bytesPerSecond).toBeCloseTo((PIECE * 1000) / 100);
  });
});
