// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { Scene, VolumeLayer } from "../../src/generated/protocol";
import { VolumeSection } from "../../src/panels/volume/volume_section";
import { stand, type Stand } from "./stand";

type Point = [number, number];
const LOW: Point = [0, 0];
const MIDDLE: Point = [0.5, 0.5];
const HIGH: Point = [1, 1];

const layer: VolumeLayer = {
  type: "volume",
  array: "p",
  opacity_points: [LOW, MIDDLE, HIGH],
};
const section = (change: Partial<VolumeLayer> = {}): Stand => {
  const scene: Scene = { dataset: "box", layers: { fog: { ...layer, ...change } } };
  return stand(<VolumeSection />, scene);
};

describe("volumes", () => {
  test("are hidden, removed and added by their buttons", () => {
    const { calls, click } = section();
    click("Hide this volume");
    click("Remove this volume");
    click("Add a volume");
    expect(calls).toEqual([
      ["layers.set", "fog", { visible: false }],
      ["layers.remove", "fog"],
      ["layers.add", "volume", expect.objectContaining({ type: "volume", array: "p" })],
    ]);
  });

  test("of another array lose the range of the one before", () => {
    const { calls, choose } = section();
    choose("Array of the volume", "T");
    expect(calls).toEqual([["layers.set", "fog", { array: "T", color: { array: null, range: null } }]]);
  });

  test("take slices, a length and shading", () => {
    const { calls, choose, click, type } = section({ slices: 50 });
    choose("Slices across", "z");
    type("Number of slices", "0");
    type("Length in m", "0.5");
    click("Shaded");
    expect(calls).toEqual([
      ["layers.set", "fog", { direction: "z" }],
      ["layers.set", "fog", { slices: null }],
      ["layers.set", "fog", { unit_length: 0.5 }],
      ["layers.set", "fog", { shaded: false }],
    ]);
  });
});

describe("the opacity curve", () => {
  const points = (calls: Stand["calls"]): unknown[] =>
    calls.map(([, , change]) => (change as VolumeLayer).opacity_points);

  test("has points that are dragged, as one gesture", () => {
    const { calls, drag } = section();
    drag("Opacity point 2", [50, 50], [60, 20], [70, 10]);
    expect(points(calls)).toEqual([
      [LOW, [0.6, 0.8], HIGH],
      [LOW, [0.7, 0.9], HIGH],
    ]);
    expect(calls.map(([name, id, , gesture]) => [name, id, gesture])).toEqual([
      ["layers.set", "fog", "gesture-1"],
      ["layers.set", "fog", "gesture-1"],
    ]);
  });

  test("gets a point where the track is pressed", () => {
    const { calls, drag } = section();
    drag("Opacity over p", [25, 90]);
    expect(points(calls)).toEqual([[LOW, [0.25, 0.1], MIDDLE, HIGH]]);
  });

  test("loses a point by a key, and moves one by another", () => {
    const { calls, key } = section();
    key("Opacity point 2", "ArrowUp");
    key("Opacity point 2", "Delete");
    key("Opacity point 2", "a");
    expect(points(calls)).toEqual([
      [LOW, [0.5, 0.51], HIGH],
      [LOW, HIGH],
    ]);
  });

  test("has fields for the point in hand", () => {
    const { calls, type } = section();
    type("Opacity of opacity point 1 in percent", "20");
    type("Value of opacity point 1", "1");
    expect(points(calls)).toEqual([
      [[0, 0.2], MIDDLE, HIGH],
      [[0.1, 0], MIDDLE, HIGH],
    ]);
  });

  test("gets a point in its widest gap", () => {
    const { calls, click } = section({
      opacity_points: [LOW, HIGH],
    });
    click("Add an opacity point");
    expect(points(calls)).toEqual([[LOW, MIDDLE, HIGH]]);
  });
});
