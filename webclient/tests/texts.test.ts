// Tests the layout of title, captions and legends over the canvas.
import { describe, expect, test } from "vitest";
import { textPixels } from "../src/model/canvas_size";
import { inBytes, scaleOf } from "../src/model/color_scale";
import type { Coloring, Range } from "../src/generated/protocol";
import { layTexts, type AnnotatedTexts, type Box, type LegendText, type Texts } from "../src/wasm/overlay";

const size = { width: 800, height: 600 };

function legendOf(coloring: Coloring, data: Range, more: Partial<LegendText> = {}): LegendText {
  const rest = {
    units: "m/s",
    layers: "",
    missing: false,
    bothEnds: false,
    lines: [],
    controls: { width: 0, height: 0 },
  };
  return { array: "U", scale: inBytes(scaleOf(coloring, data)), ...rest, ...more };
}

function laid(legends: LegendText[], more: Partial<AnnotatedTexts> = {}): Texts {
  const background: AnnotatedTexts["background"] = { top: [0, 0, 0], bottom: [0, 0, 0] };
  return layTexts({ size, text: 12, background, title: "", captions: [], legends, ...more });
}

const words = ({ overlay }: Texts): string[] => overlay.labels.map(({ text }) => text);
const boxOf = ({ overlay }: Texts, id: string): Box | undefined => overlay.handles.find((one) => one.id === id)?.box;
const idsOf = ({ overlay }: Texts): string[] => overlay.handles.map(({ id }) => id).sort();
const holds = (outer: Box | undefined, { left, top, right, bottom }: Box): boolean =>
  outer !== undefined && left >= outer.left && top >= outer.top && right <= outer.right && bottom <= outer.bottom;

describe("a legend over the canvas", () => {
  test("has its title, its lines and its numbers, and handles on the numbers at its ends", () => {
    const found = laid([legendOf({}, [0, 20], { layers: "Boundary", lines: ["cells: 0 to 21"], missing: true })]);
    expect(words(found)).toEqual(
      expect.arrayContaining(["U [m/s]", "Boundary", "cells: 0 to 21", "0", "5", "10", "15", "20", "no value"]),
    );
    expect(idsOf(found)).toEqual(["legend 0", "legend 0 high", "legend 0 low"]);
    for (const [part, text] of [
      ["low", "0"],
      ["high", "20"],
    ])
      expect(found.overlay.labels.find((label) => label.text === text)?.box).toEqual(boxOf(found, `legend 0 ${part}`));
    for (const { box } of found.overlay.labels) expect(holds(boxOf(found, "legend 0"), box)).toBe(true);
  });

  test("of a constant has one number and no ends to change", () => {
    const found = laid([legendOf({}, [3, 3])]);
    expect(words(found)).toEqual(["U [m/s]", "3"]);
    expect(idsOf(found)).toEqual(["legend 0"]);
    const held = laid([legendOf({ range: [3, 3] }, [0, 9], { bothEnds: true })]);
    expect(words(held)).toEqual(["U [m/s]", "3", "3"]);
    expect(idsOf(held)).toEqual(["legend 0", "legend 0 high", "legend 0 low"]);
  });

  test("keeps room for its controls below the bar", () => {
    const controls = { width: 150, height: 26 };
    const found = laid([legendOf({}, [0, 1], { controls })]);
    const [all, room] = [boxOf(found, "legend 0"), boxOf(found, "legend 0 controls")];
    if (room === undefined) throw new Error("no room");
    expect(room.right - room.left).toBeGreaterThanOrEqual(150);
    expect(room.bottom - room.top).toBeCloseTo(26, 9);
    expect(holds(all, room)).toBe(true);
    for (const { box } of found.overlay.labels) expect(box.bottom <= room.top).toBe(true);
  });

  test("shows the colors of its scale, of missing values and of values outside its range", () => {
    const coloring: Coloring = { map: "grayscale", nan: "#ff0000", below: "#00ff00", above: "#0000ff" };
    const { fills } = laid([legendOf(coloring, [0, 1], { missing: true })]).overlay;
    const tops = fills.map(({ top }) => top);
    expect(tops).toEqual(
      expect.arrayContaining(["rgb(255 0 0 / 1)", "rgb(0 255 0 / 1)", "rgb(0 0 255 / 1)", "rgb(255 255 255 / 1)"]),
    );
    const points = {
      points: [
        { at: 0, color: "#102030" },
        { at: 1, color: "#405060" },
      ],
    };
    const bottoms = laid([legendOf(points, [0, 1])]).overlay.fills.map(({ bottom }) => bottom);
    expect(bottoms).toContain("rgb(16 32 48 / 1)");
    const stepped = laid([legendOf({ ...points, steps: 2, reverse: true }, [0, 1])]).overlay.fills;
    expect(stepped.map(({ top }) => top)).toEqual(expect.arrayContaining(["rgb(16 32 48 / 1)", "rgb(64 80 96 / 1)"]));
  });

  test("has no label of ten before its power on a logarithmic scale", () => {
    for (const decades of [1, 6, 12])
      for (const low of [-30, -7, 0, 3, 20])
        for (const steps of [0, 5, 12]) {
          const range: Range = [Number(`1e${low}`), Number(`1e${low + decades}`)];
          const found = words(laid([legendOf({ range, log: true, steps }, [0, 1])]));
          expect(found.filter((label) => label.startsWith("10 \u00d7"))).toEqual([]);
        }
  });
});

describe("several texts over the canvas", () => {
  test("cover nothing of each other, and tell which boxes they take", () => {
    const legends = [legendOf({}, [0, 1]), legendOf({}, [5, 9], { array: "T" })];
    const found = laid(legends, { title: "A title", captions: ["dataset", "Time: 3"] });
    expect(words(found)).toEqual(expect.arrayContaining(["A title", "dataset", "Time: 3", "U [m/s]", "T [m/s]"]));
    const [first, second] = [boxOf(found, "legend 0"), boxOf(found, "legend 1")];
    expect(second?.top ?? 0).toBeGreaterThan(first?.bottom ?? Infinity);
    for (const { box } of found.overlay.labels) expect(found.taken.some((taken) => holds(taken, box))).toBe(true);
  });

  test("leave out the last legends where there is no room, and say how many", () => {
    const legends = Array.from({ length: 12 }, (_, i) => legendOf({}, [0, 1], { array: `array ${i}` }));
    const found = laid(legends, { size: { width: 400, height: 300 } });
    const shown = found.overlay.handles.filter(({ id }) => /^legend \d+$/.test(id)).length;
    expect(shown).toBeGreaterThan(0);
    expect(shown).toBeLessThan(legends.length);
    expect(idsOf(found)).toContain(`legend ${shown - 1}`);
    expect(words(found)).toContain(`+ ${legends.length - shown} more`);
  });

  test("have smaller letters in small pictures, down to what can be read", () => {
    const text = (width: number, height: number): number => textPixels({ width, height });
    expect([text(1600, 900), text(956, 690), text(420, 310), text(360, 210)]).toEqual([12, 12, 9, 9]);
    expect(text(600, 900)).toBeCloseTo(9.64, 2);
  });
});
