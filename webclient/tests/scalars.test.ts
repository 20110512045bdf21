import { describe, expect, test } from "vitest";
import type { ArrayInfo, Coloring, Contours, DatasetDescription, Layer, Scene } from "../src/generated/protocol";
import {
  arrayOf,
  boundaryScalarsOf,
  firstScalar,
  freeId,
  layersOf,
  legendsOf,
  nearestStep,
  rangeOfAllSteps,
  allScalarsOf,
  topOrder,
  unitsOf,
} from "../src/model/scalars";

const array = (name: string, components: number, scalars: string[]): ArrayInfo => ({
  name,
  association: "point",
  components,
  units: "m^2/s^2",
  description: "",
  range: [-1, 5],
  scalars,
  times: [0],
  origin: "original",
  stored: "float32",
  invalid: 0,
  missing: 0,
});
const description = {
  arrays: [
    array("p", 1, ["p"]),
    array("U", 3, ["U:x", "U:y", "U:z", "U:magnitude"]),
    { ...array("cell:p", 1, ["cell:p"]), association: "cell" },
    { ...array("cell:U", 3, ["cell:U:magnitude"]), association: "cell" },
    { ...array("patch:p", 1, ["patch:p"]), association: "boundary_face" },
  ],
} as unknown as DatasetDescription;
const scene: Scene = {
  dataset: "d",
  layers: {
    a: { type: "iso", array: "p", values: [0], order: 5, color: { array: "p" } },
    b: { type: "iso", array: "p", values: [1], order: 2, color: { array: "p", map: "viridis" } },
    c: { type: "slice", axis: "x", value: 0, color: { array: "p", range: [0, 1] } },
    d: { type: "surface", visible: false, color: { array: "U:x" } },
    e: { type: "surface", color: {} },
    outline: { type: "outline" },
  },
};

test("surfaces can be colored by what belongs to cells, and cells chosen by it", () => {
  const names = allScalarsOf(description).map(({ name }) => name);
  expect(names).toEqual(["p", "U:x", "U:y", "U:z", "U:magnitude", "cell:p", "cell:U:magnitude"]);
  expect(allScalarsOf(null)).toEqual([]);
});

test("a further layer begins with what the dataset is first shown by, not with its first array", () => {
  const iso: Layer = { type: "iso", array: "U:x", values: [0] };
  expect(firstScalar({ ...description, default_scene: { dataset: "d", layers: { iso } } })).toBe("U:x");
  expect(firstScalar({ ...description, default_scene: { dataset: "d" } })).toBe("p");
  expect(firstScalar(null)).toBeUndefined();
});

describe("scalars", () => {
  test("units belong to the array, the range of all steps to scalars and magnitudes", () => {
    expect(unitsOf(description, "U:x")).toBe("m\u00b2/s\u00b2");
    expect(unitsOf(description, "cell:p")).toBe("m\u00b2/s\u00b2"); // a probe reads whole cell vectors by this name
    expect(unitsOf(description, "cell:p:x")).toBe("m\u00b2/s\u00b2");
    expect(unitsOf(description, "gone")).toBe("");
    expect(rangeOfAllSteps(description, "p")).toEqual([-1, 5]);
    expect(rangeOfAllSteps(description, "U:magnitude")).toEqual([-1, 5]);
    expect(rangeOfAllSteps(description, "U:x")).toBeNull();
    expect(rangeOfAllSteps(null, "p")).toBeNull();
  });

  test("the nearest step", () => {
    expect([-9, 0.2, 0.3, 99].map((time) => nearestStep([0, 0.5, 1], time))).toEqual([0, 0, 1, 2]);
    expect(nearestStep([], 1)).toBe(0);
  });

  test("layers in drawing order, and a place for one more", () => {
    expect(layersOf(scene, "iso").map(([id]) => id)).toEqual(["b", "a"]);
    expect([freeId(scene, "a"), freeId(scene, "slice")]).toEqual(["a2", "slice"]);
    expect(topOrder(scene)).toBe(6);
  });

  test("one legend for layers that share their colors, in their order, none for what is hidden or of one color", () => {
    expect(legendsOf(scene, null).map(({ coloring, of }) => [coloring.array, coloring.range, of.layers])).toEqual([
      ["p", [0, 1], ["c"]],
      ["p", undefined, ["b", "a"]],
    ]);
    expect(legendsOf(null, null)).toEqual([]);
  });

  test("contour lines in the colors of their values have a legend, with a layer's where the scales are the same", () => {
    const slice = (color: Coloring, contours: Contours): Layer => ({
      type: "slice",
      axis: "x",
      value: 0,
      color,
      contours,
    });
    const layers = {
      a: slice({ array: "p" }, { array: "p", coloring: {} }),
      b: slice({ array: "p" }, { array: "U:x", coloring: { map: "vik" } }),
      c: slice({}, { array: "U:x", coloring: { map: "vik" } }),
      d: slice({}, { array: "U:y", coloring: {}, visible: false }),
      e: slice({}, { array: "U:z" }), // drawn in one color, so without legend
    };
    expect(legendsOf({ layers }, null).map(({ coloring, of }) => [coloring.array, of])).toEqual([
      ["p", { layers: ["a", "b"], contours: ["a"] }],
      ["U:x", { layers: [], contours: ["b", "c"] }],
    ]);
  });
});

test("values of patches color boundaries, and nothing else", () => {
  const names = (scalars: { name: string }[]): string[] => scalars.map(({ name }) => name);
  expect(names(boundaryScalarsOf(description))).toEqual([...names(allScalarsOf(description)), "patch:p"]);
  expect(arrayOf(description, "patch:p")?.association).toBe("boundary_face");
});
