import { describe, expect, test } from "vitest";
import type { Layer } from "../src/generated/protocol";
import { layerName, layerNames } from "../src/model/layer_names";

describe("what a layer is called", () => {
  test.each<[Layer, string]>([
    [{ type: "iso", array: "p", values: [0.5, -1] }, "Iso-surface of p at 0.5, \u22121"],
    [{ type: "iso", array: "p", values: [1, 2, 3, 4, 5] }, "Iso-surface of p at 1, 2, 3 and 2 more"],
    [{ type: "iso", array: "U:x", values: [] }, "Iso-surface of U:x at no value"],
    [{ type: "slice", axis: "z", value: 1.5 }, "Slice at z = 1.5"],
    [{ type: "slice", origin: [0, 0, 1], normal: [1, 1, 0] }, "Plane through (0, 0, 1), normal (1, 1, 0)"],
    [{ type: "surface" }, "Whole boundary"],
    [{ type: "surface", groups: ["inlet", "wall"] }, "Boundary: inlet, wall"],
    [{ type: "outline" }, "Outline"],
    [{ type: "clip", axis: "x", value: 2 }, "Clip at x = 2"],
    [{ type: "clip", origin: [0, 0, 1], normal: [1, 1, 0] }, "Clip: Plane through (0, 0, 1), normal (1, 1, 0)"],
    [{ type: "edges" }, "Edges of the boundary"],
    [{ type: "edges", angle: 30 }, "Edges that bend by 30°"],
    [{ type: "points" }, "Points of the boundary"],
    [{ type: "points", of: "all" }, "All points"],
  ])("%j", (layer, name) => {
    expect(layerName(layer)).toBe(name);
  });

  test("layers of one name are told apart", () => {
    const layers: Record<string, Layer> = { a: { type: "surface" }, b: { type: "outline" }, c: { type: "surface" } };
    expect([...layerNames({ layers })]).toEqual([
      ["a", "Whole boundary"],
      ["b", "Outline"],
      ["c", "Whole boundary (2)"],
    ]);
    expect(layerNames(null).size).toBe(0);
  });
});
