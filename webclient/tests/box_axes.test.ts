import { describe, expect, test } from "vitest";
import { complete, project, type Bounds, type FullCamera } from "../src/camera/camera";
import type { Vec3 } from "../src/camera/vector";
import { boxAxes, type BoxAxis } from "../src/scene/box_axes";

const size = { width: 800, height: 600 };
const bounds: Bounds = [-1, 1, -1, 1, -1, 1];
const look = (position: Vec3, target: Vec3 = [0, 0, 0], parallel = false): FullCamera =>
  complete({ position, target, up: [0, 0, 1], fov: 30, parallel, parallel_height: 4 });

const ends = (camera: FullCamera, axis: BoxAxis | undefined, low: Vec3, high: Vec3): void => {
  for (const [place, corner] of [
    [axis?.from, low],
    [axis?.to, high],
  ] as const) {
    expect(place?.x).toBeCloseTo(project(camera, corner, size)?.x ?? NaN, 6);
    expect(place?.y).toBeCloseTo(project(camera, corner, size)?.y ?? NaN, 6);
  }
};

describe("the axes of the box", () => {
  test.each([false, true])("are the lower silhouette edges and the left one (parallel: %s)", (parallel) => {
    const camera = look([4, -8, 4], [0, 0, 0], parallel);
    const axes = boxAxes(camera, bounds, size);
    expect(axes.map(({ name }) => name)).toEqual(["x", "y", "z"]);
    ends(camera, axes[0], [-1, -1, -1], [1, -1, -1]);
    ends(camera, axes[1], [1, -1, -1], [1, 1, -1]);
    ends(camera, axes[2], [-1, -1, -1], [-1, -1, 1]);
    expect(axes[0]?.outward.y).toBeGreaterThan(0.9);
    expect(axes[2]?.outward.x).toBeLessThan(-0.9);
  });

  test("are two where a face is seen from the front", () => {
    expect(boxAxes(look([0, -6, 0]), bounds, size).map(({ name }) => name)).toEqual(["x", "z"]);
  });

  test("are none from inside, nor behind the eye", () => {
    expect(boxAxes(look([0, -0.5, 0.2]), bounds, size)).toEqual([]);
    expect(boxAxes(look([0, -6, 0], [0, -12, 0]), bounds, size)).toEqual([]);
  });

  test("have round numbers at their world positions", () => {
    const camera = look([4, -8, 4]);
    const [x] = boxAxes(camera, bounds, size);
    expect(x?.ticks.map(({ label }) => label)).toEqual(["\u22121", "0", "1"]);
    const place = project(camera, [1, -1, -1], size);
    expect(x?.ticks[2]?.x).toBeCloseTo(place?.x ?? NaN, 6);
  });

  test("keep their ticks in the picture when only a part of an edge is seen", () => {
    const camera = look([1, -3, -1], [1, 0, -1]);
    for (const axis of boxAxes(camera, bounds, size)) {
      for (const { x, y } of axis.ticks) {
        expect(x >= 0 && x <= size.width && y >= 0 && y <= size.height).toBe(true);
      }
    }
  });

  test("of a flat box are those that have a length", () => {
    expect(boxAxes(look([0, -6, 3]), [-1, 1, -1, 1, 0, 0], size).map(({ name }) => name)).not.toContain("z");
  });
});
