import { describe, expect, test } from "vitest";
import { barHeight, legendText, roomFor } from "../src/model/overlay_room";
import type { Box } from "../src/wasm/overlay";

const stage = { width: 320, height: 300 };
const box = (left: number, top: number, width: number, height: number): Box => ({
  left,
  top,
  right: left + width,
  bottom: top + height,
});
const captions = [box(14, 10, 140, 50)];

describe("room over the canvas", () => {
  test("is for all where nothing meets", () => {
    const legends = [box(210, 10, 100, 130), box(210, 150, 100, 130)];
    const room = roomFor({ captions, legends }, stage);
    expect(room).toEqual({ legends: [true, true], taken: [...captions, ...legends] });
  });

  test("captions stay, a legend on them goes, and those after it", () => {
    const wide = [box(14, 10, 160, 50)];
    const legends = [box(210, 10, 100, 130), box(165, 10, 40, 130), box(165, 150, 40, 130)];
    const { legends: shown, taken } = roomFor({ captions: wide, legends }, stage);
    expect(shown).toEqual([true, false, false]);
    expect(taken).toEqual([...wide, legends[0]]);
  });

  test("further columns of legends begin in the right half, the first in the right two thirds", () => {
    const of = (...legends: Box[]): boolean[] => roomFor({ captions: [], legends }, stage).legends;
    expect(of(box(210, 10, 100, 130), box(161, 10, 40, 130))).toEqual([true, true]);
    expect(of(box(210, 10, 100, 130), box(159, 10, 40, 130))).toEqual([true, false]);
    expect(of(box(110, 10, 200, 130))).toEqual([true]);
    expect(of(box(100, 10, 200, 130))).toEqual([false]);
  });

  test("what sticks out of the stage has none", () => {
    const legends = [box(210, 10, 100, 400)];
    expect(roomFor({ captions: [], legends }, stage)).toEqual({
      legends: [false],
      taken: [],
    });
  });
});

describe("legends", () => {
  test("have smaller text in small pictures, down to what can be read", () => {
    const text = (width: number, height: number): number => legendText({ width, height });
    expect([text(1600, 900), text(956, 690), text(420, 310), text(360, 210)]).toEqual([12, 12, 9, 9]);
    expect(text(600, 900)).toBeCloseTo(9.64, 2);
  });

  test("have bars that share the height, and are never shorter than what has a beginning and an end", () => {
    const bar = (height: number, count: number): number => barHeight({ width: 600, height }, count, 10);
    expect([bar(900, 1), bar(400, 1), bar(400, 2), bar(400, 3), bar(200, 4)]).toEqual([140, 104, 104, 50, 50]);
  });
});
