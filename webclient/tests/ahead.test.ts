import { describe, expect, test } from "vitest";
import { complete, project, type Bounds } from "../src/model/camera";
import type { Camera, Layer, Scene } from "../src/generated/protocol";
import { ahead, planeOutline } from "../src/model/ahead";

const bounds: Bounds = [0, 2, 0, 2, 0, 2];
const size = { width: 400, height: 300 };
const camera: Camera = { position: [1, -8, 1], target: [1, 1, 1], up: [0, 0, 1] };
const turned: Camera = { position: [-7, 1, 1], target: [1, 1, 1], up: [0, 0, 1] };
const layers: Record<string, Layer> = {
  iso: { type: "iso", array: "p", values: [1] },
  slice: { type: "slice", axis: "x", value: 0.5 },
};
const scene: Scene = { dataset: "d", camera, layers };
const seen = (wanted: Scene): ReturnType<typeof ahead> =>
  ahead(scene, wanted, complete(wanted.camera ?? camera), bounds, size);

describe("ahead of the picture", () => {
  test("nothing where the picture shows what is wanted", () => {
    expect(seen(structuredClone(scene))).toEqual({ lines: [], words: [] });
  });

  test("the box as the wanted camera sees it", () => {
    const { lines, words } = seen({ ...scene, camera: turned });
    expect(words).toEqual([]);
    expect(lines.length).toBe(12);
    const corner = project(complete(turned), [0, 0, 0], size);
    expect(lines.some(({ x1, y1 }) => x1 === corner?.x && y1 === corner.y)).toBe(true);
  });

  test("the wanted plane, where the box ends", () => {
    const moved: Layer = { type: "slice", axis: "x", value: 1.5 };
    const { lines } = seen({ ...scene, layers: { ...layers, slice: moved } });
    const at = [...new Set(lines.flatMap(({ x1, x2 }) => [x1, x2]).map((x) => Math.round(x)))];
    const sides = [0, 2].map((y) => Math.round(project(complete(camera), [1.5, y, 0], size)?.x ?? 0));
    expect(lines.length).toBe(4);
    expect(at.sort()).toEqual(sides.sort());
  });

  test("the wanted value and time in words", () => {
    const iso: Layer = { type: "iso", array: "p", values: [1.25] };
    expect(seen({ ...scene, time: 0.5, layers: { ...layers, iso } }).words).toEqual(["p = 1.25", "time 0.5"]);
  });

  test("hidden layers are not drawn", () => {
    const slice: Layer = { type: "slice", axis: "x", value: 1.5, visible: false };
    expect(seen({ ...scene, layers: { ...layers, slice } }).lines).toEqual([]);
  });

  test.each([
    { name: "across a corner", origin: [0.2, 0.2, 0.2], normal: [1, 1, 1], sides: 3 },
    { name: "through the middle", origin: [1, 1, 1], normal: [1, 1, 1], sides: 6 },
    { name: "beside the box", origin: [5, 0, 0], normal: [1, 0, 0], sides: 0 },
  ] as const)("a plane $name has $sides sides", ({ origin, normal, sides }) => {
    expect(planeOutline([...origin], [...normal], bounds).length).toBe(sides);
  });
});
