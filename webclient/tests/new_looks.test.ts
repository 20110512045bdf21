import { describe, expect, test } from "vitest";
import type { DatasetDescription, Layer, Scene } from "../src/generated/protocol";
import { capColoring, coloredBy, freshArray, freshSolid, keepsFarHalf } from "../src/model/new_looks";

const description = {
  arrays: [
    { name: "p", components: 1, association: "point", scalars: ["p"] },
    { name: "U", components: 3, association: "point", scalars: ["U:x", "U:y", "U:z", "U:magnitude"] },
    { name: "q", components: 1, association: "cell", scalars: [] },
  ],
  default_scene: { dataset: "d", layers: { iso: { type: "iso", array: "p", values: [1] } } },
} as unknown as DatasetDescription;
const scene = (layers: Record<string, Layer>): Scene => ({ dataset: "d", layers });
const slice = (array?: string): Layer => ({
  type: "slice",
  axis: "x",
  value: 0,
  color: array === undefined ? {} : { array },
});

describe("a further slice", () => {
  test("shows an array that no other does, vectors by their magnitude", () => {
    expect(freshArray(scene({}), description)).toBe("p");
    expect(freshArray(scene({ a: slice("p") }), description)).toBe("U:magnitude");
    expect(freshArray(scene({ a: slice("U") }), description)).toBe("p");
  });

  test("shows the first where all are shown", () => {
    expect(freshArray(scene({ a: slice("p"), b: slice("U:magnitude") }), description)).toBe("p");
  });
});

test("equal arrays share one scale, whatever else a layer is like", () => {
  const color = { array: "U", map: "magma", range: [1, 2] as [number, number], log: true, solid: "#ff0000" };
  const shown = scene({ a: { type: "surface", color }, b: slice() });
  expect(coloredBy(shown, description, "U:magnitude")).toEqual({
    array: "U:magnitude",
    map: "magma",
    range: [1, 2],
    log: true,
  });
  expect(coloredBy(shown, description, "p")).toEqual({ array: "p" });
});

test("a further surface in one color has one that no other of its kind has", () => {
  const iso = (solid?: string): Layer => ({
    type: "iso",
    array: "p",
    values: [1],
    color: solid === undefined ? {} : { solid },
  });
  expect(freshSolid(scene({}), "iso")).toEqual({});
  expect(freshSolid(scene({ a: iso() }), "iso")).toEqual({ solid: "#e69f00" });
  expect(freshSolid(scene({ a: iso(), b: iso("#e69f00") }), "iso")).toEqual({ solid: "#56b4e9" });
  expect(freshSolid(scene({ a: iso() }), "surface")).toEqual({});
});

describe("a clip", () => {
  test("has caps in the colors of the data, unless the surface that it closes has them", () => {
    expect(capColoring(scene({}), description)).toEqual({ color: { array: "p" } });
    expect(capColoring(scene({ a: { type: "surface", color: { array: "U:x" } } }), description)).toEqual({});
    const patches: Layer = { type: "surface", groups: ["wall"], color: { array: "U:x" } };
    expect(capColoring(scene({ a: patches }), description)).toEqual({ color: { array: "p" } });
  });

  test("keeps the half that shows the cut", () => {
    const camera = { position: [10, 0, 0] as [number, number, number], target: [0, 0, 0] as [number, number, number] };
    expect(keepsFarHalf([1, 0, 0], camera)).toBe(false); // removes the half towards the eye
    expect(keepsFarHalf([-1, 0, 0], camera)).toBe(true);
    expect(keepsFarHalf([1, 0, 0], null)).toBe(false);
  });
});
