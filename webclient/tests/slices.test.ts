import { describe, expect, test } from "vitest";
import type { Bounds } from "../src/model/camera";
import type { SliceLayer } from "../src/generated/protocol";
import { applyPatch, type Json } from "../src/model/merge_patch";
import { AXES } from "../src/model/axes";
import { furtherSlice, likeThis, looksInWords, planeChange, type Slices } from "../src/model/slices";

const bounds: Bounds = [0, 10, -4, 4, 1, 3];
const across = (axis: "x" | "y" | "z", value: number, looks: Partial<SliceLayer> = {}): SliceLayer => ({
  type: "slice",
  axis,
  value,
  ...looks,
});
const free: SliceLayer = { type: "slice", origin: [9, -20, 2], normal: [1, 1, 0] };
const looks: Partial<SliceLayer> = {
  color: { array: "p", map: "vik" },
  opacity: 0.5,
  contours: { array: "q", count: 3 },
  edges: { width: 2 },
};

describe("a further slice", () => {
  test("lies in the middle, the next across that axis in the widest gap", () => {
    const slices: [string, SliceLayer][] = [];
    const values = (["x", "y", "x", "x", "z"] as const).map((axis) => {
      const slice = furtherSlice(slices, axis, bounds, { array: "p" });
      slices.push([`${slices.length}`, slice]);
      return [slice.axis, slice.value];
    });
    expect(values).toEqual([
      ["x", 5],
      ["y", 0],
      ["x", 2.5],
      ["x", 7.5],
      ["z", 2],
    ]);
  });

  test("that is free goes through the middle, each another way", () => {
    const slices: [string, SliceLayer][] = [];
    for (let i = 0; i < 6; i += 1) slices.push([`${i}`, furtherSlice(slices, "free", bounds, { array: "p" })]);
    expect(slices[0]?.[1]).toEqual({ type: "slice", origin: [5, 0, 2], normal: [1, 1, 0], color: { array: "p" } });
    expect(new Set(slices.map(([, { normal }]) => String(normal))).size).toBe(6);
    expect(furtherSlice(slices, "free", bounds, { array: "p" }).normal).toEqual([1, 1, 0]);
  });

  test("has the lines and the opacity of the last one in the colors that are given, and is seen", () => {
    const slices: Slices = [
      ["a", across("x", 1, { color: { array: "q" } })],
      ["b", across("z", 2, { ...looks, visible: false, order: 7 })],
    ];
    expect(furtherSlice(slices, "y", bounds, { array: "p" })).toEqual(
      across("y", 0, { ...looks, color: { array: "p" } }),
    );
    expect(furtherSlice([], "y", bounds, { array: "p" }).color).toEqual({ array: "p" });
    expect(furtherSlice([], "y", bounds, {}).color).toEqual({});
  });
});

describe("a slice that is laid elsewhere", () => {
  const laid = (slice: SliceLayer, to: "x" | "y" | "z" | "free", slices: Slices = []): Json =>
    applyPatch(slice as unknown as Json, planeChange(slices, slice, to, bounds) as Json);

  test("keeps its looks, and lies where none lies yet", () => {
    expect(laid(across("x", 1, looks), "y", [["b", across("y", 0)]])).toEqual(across("y", -2, looks));
  });

  test("and made free is where it was, in a plane that can be turned", () => {
    expect(laid(across("y", 3, looks), "free")).toEqual({
      type: "slice",
      origin: [5, 3, 2],
      normal: [0, 1, 0],
      ...looks,
    });
  });

  test("from a free plane goes through its origin, and through the data", () => {
    expect(laid(free, "x")).toEqual(across("x", 9));
    expect(laid(free, "y")).toEqual(across("y", -4));
  });

  test("where it lies already is no change", () => {
    for (const axis of AXES) expect(planeChange([], across(axis, 1), axis, bounds)).toEqual({});
    expect(planeChange([], free, "free", bounds)).toEqual({});
  });
});

describe("looks", () => {
  test("are given to all others, which keep their planes, and what is more than these goes", () => {
    const slices: [string, SliceLayer][] = [
      ["a", across("x", 1, looks)],
      ["b", across("y", 2, { color: { array: "q", range: [0, 1] }, edges: { color: "#ffffff" }, visible: false })],
      ["c", free],
      ["d", across("x", 3, looks)],
    ];
    const change = likeThis(slices, "a");
    expect(Object.keys(change)).toEqual(["b", "c"]);
    expect(applyPatch(Object.fromEntries(slices) as never, change as never)).toEqual({
      a: slices[0]?.[1],
      b: across("y", 2, { ...looks, visible: false }),
      c: { ...free, ...looks },
      d: slices[3]?.[1],
    });
    expect(likeThis(slices.slice(0, 1), "a")).toEqual({});
  });

  test("in a few words", () => {
    expect(looksInWords(across("x", 1, looks))).toBe("p, lines of q, cell edges");
    expect(looksInWords(across("x", 1, { contours: { array: "q", visible: false }, edges: { visible: false } }))).toBe(
      "one color",
    );
  });
});
