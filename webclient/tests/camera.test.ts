import { describe, expect, test } from "vitest";
import {
  AXIS_VIEWS,
  axisView,
  center,
  clearOf,
  complete,
  corners,
  defaultView,
  distance,
  frame,
  orbit,
  pan,
  project,
  roll,
  viewHeight,
  REACH,
  withFieldOfView,
  withinReach,
  withParallel,
  withViewHeight,
  zoom,
  type Bounds,
  type ViewCamera,
} from "../src/model/camera";
import { dragOf, wheelFactor } from "../src/view/gestures";
import { depthRange, projectionMatrix, viewMatrix } from "../src/view/matrices";
import { add, dot, length, multiply, scale, subtract, type Vec3 } from "../src/model/vector";

const size = { width: 800, height: 500 };
const bounds: Bounds = [10, 14, -3, 5, 100, 101];
const start = complete({ position: [20, -30, 110], target: [12, 1, 100.5], up: [0, 0, 1], fov: 35 });
const close = (a: Vec3, b: Vec3, digits = 9): void => a.forEach((v, i) => expect(v).toBeCloseTo(b[i] ?? NaN, digits));

function expectRightAngled(camera: ViewCamera): void {
  const { right, up, forward } = frame(camera);
  for (const axis of [right, up, forward]) expect(length(axis)).toBeCloseTo(1, 12);
  for (const [a, b] of [
    [right, up],
    [up, forward],
    [forward, right],
  ] as const) {
    expect(dot(a, b)).toBeCloseTo(0, 12);
  }
}

const along = (axes: ReturnType<typeof frame>, right: number, up: number, forward: number): Vec3 =>
  add(add(scale(axes.right, right), scale(axes.up, up)), scale(axes.forward, forward));

describe("orbit", () => {
  test("keeps the target and the distance, however long", () => {
    let camera = start;
    for (let i = 0; i < 500; i += 1) camera = orbit(camera, 13 * Math.sin(i), 17 * Math.cos(3 * i), size);
    expect(distance(camera)).toBeCloseTo(distance(start), 8);
    close(camera.target, start.target);
    expectRightAngled(camera);
  });

  test("a pivot stays where it is seen and as far away, and the target turns about it", () => {
    const pivot = add(start.target, along(frame(start), 3, -2, 5));
    const before = project(start, pivot, size);
    let camera = start;
    for (let i = 0; i < 200; i += 1) camera = orbit(camera, 13 * Math.sin(i), 17 * Math.cos(3 * i), size, pivot);
    const after = project(camera, pivot, size);
    expect(after?.x).toBeCloseTo(before?.x ?? NaN, 6);
    expect(after?.y).toBeCloseTo(before?.y ?? NaN, 6);
    expect(after?.depth).toBeCloseTo(before?.depth ?? NaN, 8);
    expect(length(subtract(camera.target, pivot))).toBeCloseTo(length(subtract(start.target, pivot)), 8);
    expect(distance(camera)).toBeCloseTo(distance(start), 8);
    expectRightAngled(camera);
  });

  test("a drag to the right brings the left side to the front", () => {
    const leftSide = subtract(start.target, frame(start).right);
    const before = project(start, leftSide, size);
    const after = project(orbit(start, 40, 0, size), leftSide, size);
    expect(after?.x).toBeGreaterThan(before?.x ?? Infinity);
    expect(after?.depth).toBeLessThan(before?.depth ?? 0);
  });

  test("a drag downwards shows the top", () => {
    const top = add(start.target, frame(start).up);
    const after = project(orbit(start, 0, 40, size), top, size);
    expect(after?.depth).toBeLessThan(project(start, top, size)?.depth ?? 0);
    expect(after?.y).toBeGreaterThan(project(start, top, size)?.y ?? Infinity);
  });

  test("half a turn over the shorter side, past the pole without a jump", () => {
    const turned = orbit(start, 0, size.height, size);
    close(subtract(turned.position, turned.target), scale(subtract(start.position, start.target), -1), 6);
  });
});

describe("the field of view", () => {
  const beside = add(start.target, scale(frame(start).right, 0.7));
  const behind = add(beside, scale(frame(start).forward, 3));

  test("keeps in place what lies at the target's depth, and draws together what lies behind", () => {
    for (const fov of [1, 20, 60, 120]) {
      const seen = withFieldOfView(start, fov);
      expect(seen.fov).toBe(fov);
      expect(viewHeight(seen)).toBeCloseTo(viewHeight(start), 9);
      close([project(seen, beside, size)?.x ?? NaN, 0, 0], [project(start, beside, size)?.x ?? NaN, 0, 0], 6);
      expectRightAngled(seen);
    }
    const away = (fov: number): number => (project(withFieldOfView(start, fov), behind, size)?.x ?? NaN) - 400;
    expect(away(60)).toBeLessThan(away(30));
    expect(away(1)).toBeGreaterThan(0.97 * (project(start, beside, size)?.x ?? NaN) - 0.97 * 400);
  });

  test("and back again is the same view", () => {
    close(withFieldOfView(withFieldOfView(start, 90), 35).position, start.position);
  });

  test("the height of the view is what it spans, parallel or not", () => {
    for (const camera of [start, withParallel(start, true)]) {
      const seen = withViewHeight(camera, 2.5);
      expect(viewHeight(seen)).toBeCloseTo(2.5, 9);
      close(seen.target, camera.target);
    }
  });
});

describe("pan", () => {
  test("what lies at the target's depth follows the hand", () => {
    for (const camera of [start, withParallel(start, true)]) {
      const at = project(pan(camera, 37, -21, size), camera.target, size);
      expect(at?.x).toBeCloseTo(size.width / 2 + 37, 6);
      expect(at?.y).toBeCloseTo(size.height / 2 - 21, 6);
    }
  });
});

describe("zoom", () => {
  test.each([start, withParallel(start, true)])("the point under the cursor stays (parallel: $parallel)", (camera) => {
    const point = add(camera.target, add(scale(frame(camera).right, 2), scale(frame(camera).up, -1)));
    const before = project(camera, point, size);
    if (before === null) throw new Error("behind the eye");
    const closer = zoom(camera, 0.5, before.x, before.y, size);
    const after = project(closer, point, size);
    expect(after?.x).toBeCloseTo(before.x, 6);
    expect(after?.y).toBeCloseTo(before.y, 6);
    expect(viewHeight(closer)).toBeCloseTo(viewHeight(camera) / 2, 9);
  });

  const diagonal = 9;
  const reach = (camera: ViewCamera): number =>
    (camera.parallel ? camera.parallel_height : distance(camera)) / diagonal;
  const zoomedOften = (camera: ViewCamera, factor: number): ViewCamera => {
    for (let i = 0; i < 200; i += 1) camera = zoom(camera, withinReach(camera, factor, bounds), 20, 30, size);
    return camera;
  };
  test.each([start, withParallel(start, true)])("there are stops (parallel: $parallel)", (camera) => {
    const [nearest, furthest] = REACH;
    const closest = zoomedOften(camera, 0.8);
    expect(reach(closest) / nearest).toBeCloseTo(1, 5);
    expect(reach(zoomedOften(camera, 1.25)) / furthest).toBeCloseTo(1, 9);
    expect(withinReach(camera, 0.8, bounds)).toBe(0.8);
    expect([withinReach(closest, 0.8, bounds), withinReach(closest, 1.25, bounds)]).toEqual([1, 1.25]);
    const outside = zoom(camera, 1e8, 20, 30, size);
    expect(withinReach(outside, 1.25, bounds)).toBe(1);
    expect(withinReach(outside, 0.8, bounds)).toBe(0.8);
  });

  test("a box that is a point has stops all the same", () => {
    const point: Bounds = [1, 1, 2, 2, 3, 3];
    expect(withinReach(start, 0.8, point)).toBe(0.8);
    expect(withinReach(zoom(start, 1e-9, 20, 30, size), 0.8, point)).toBe(1);
  });

  test("the wheel zooms by the same factor in and out, whatever its unit", () => {
    expect(wheelFactor(100, 0) * wheelFactor(-100, 0)).toBeCloseTo(1, 12);
    expect(wheelFactor(3, 1)).toBeCloseTo(wheelFactor(48, 0), 12);
    expect(wheelFactor(1e9, 0)).toBeLessThan(3);
  });
});

describe("other moves", () => {
  test("roll keeps the line of sight", () => {
    const rolled = roll(start, 0.7);
    close(rolled.position, start.position);
    expect(dot(frame(rolled).up, frame(start).up)).toBeCloseTo(Math.cos(0.7), 9);
  });

  test("center brings a point to the middle from the same side", () => {
    const point: Vec3 = [11, 2, 100.2];
    const centered = center(start, point);
    expect(project(centered, point, size)).toMatchObject({ x: size.width / 2, y: size.height / 2 });
    expect(distance(centered)).toBeCloseTo(distance(start), 9);
    close(frame(centered).forward, frame(start).forward);
  });

  test("parallel and perspective span the same at the target, there and back", () => {
    const there = withParallel(start, true);
    expect(viewHeight(there)).toBeCloseTo(viewHeight(start), 9);
    const zoomed = withParallel(zoom(there, 0.25, 1, 1, size), false);
    expect(viewHeight(zoomed)).toBeCloseTo(viewHeight(start) / 4, 9);
    close(withParallel(there, false).position, start.position, 6);
  });

  test("a camera whose up is along its view still has a frame", () => {
    expectRightAngled(complete({ position: [0, 0, 5], target: [0, 0, 0], up: [0, 0, 1] }));
    expectRightAngled(complete({ position: [0, 0, 0], target: [0, 0, 0] }));
  });

  test("buttons and keys choose the drag", () => {
    expect([dragOf(0, false, false), dragOf(0, true, false), dragOf(0, false, true)]).toEqual(["orbit", "pan", "roll"]);
    expect([dragOf(1, false, false), dragOf(2, false, false)]).toEqual(["pan", "pan"]);
  });
});

describe("whole views", () => {
  const views = (aspect: number): ViewCamera[] => [
    defaultView(bounds, aspect),
    ...AXIS_VIEWS.flatMap((side) => [true, false].map((parallel) => axisView(side, bounds, aspect, 30, parallel))),
  ];

  test.each([0.4, 1, 2.5])("the box fits closely into a canvas of aspect %d", (aspect) => {
    const canvas = { width: 1000 * aspect, height: 1000 };
    for (const camera of views(aspect)) {
      const places = corners(bounds).map((corner) => project(camera, corner, canvas));
      const reach = places.map((p) =>
        p === null ? Infinity : Math.max(Math.abs(p.x / canvas.width - 0.5), Math.abs(p.y / canvas.height - 0.5)),
      );
      expect(Math.max(...reach)).toBeLessThanOrEqual(0.5);
      expect(Math.max(...reach)).toBeGreaterThan(0.4);
    }
  });

  const taken = { width: 130, height: 260 };
  test.each([false, true])("the box is clear of what lies over the corner (parallel: %s)", (parallel) => {
    const canvas = { width: 956, height: 610 };
    let moved = 0;
    for (const side of AXIS_VIEWS) {
      const view = axisView(side, bounds, canvas.width / canvas.height, 30, parallel);
      const clear = clearOf(view, bounds, canvas, taken);
      moved += clear === view ? 0 : 1;
      close(clear.target, view.target);
      for (const corner of corners(bounds)) {
        const at = project(clear, corner, canvas);
        if (at === null) throw new Error("behind the eye");
        expect(at.x > canvas.width - taken.width && at.y < taken.height).toBe(false);
      }
    }
    expect(moved).toBeGreaterThan(0);
  });

  test("no corner, no step back; too much of one is left covered", () => {
    const view = axisView("+z", bounds, 1.5, 30, false);
    const canvas = { width: 900, height: 600 };
    expect(clearOf(view, bounds, canvas, { width: 0, height: 0 })).toBe(view);
    expect(clearOf(view, bounds, canvas, { width: 600, height: 600 })).toBe(view);
  });

  test("+x stands on the positive side", () => {
    const camera = axisView("+x", bounds, 1.5, 30, false);
    expect(camera.position[0]).toBeGreaterThan(bounds[1]);
    close(frame(camera).forward, [-1, 0, 0]);
    close(frame(axisView("-z", bounds, 1.5, 30, false)).forward, [0, 0, 1]);
    close(frame(axisView("+z", bounds, 1.5, 30, false)).up, [0, 1, 0]);
  });

  test("a dataset without extent has a view", () => {
    const camera = defaultView([1, 1, 2, 2, 3, 3], 1.5);
    expect(distance(camera)).toBeGreaterThan(0);
    expect(depthRange(camera, [1, 1, 2, 2, 3, 3]).every(Number.isFinite)).toBe(true);
  });
});

describe("matrices", () => {
  test.each([start, withParallel(start, true), withParallel(defaultView(bounds, 1.6), true)])(
    "agree with the projection to pixels (parallel: $parallel)",
    (camera) => {
      const origin: Vec3 = [12, 0, 100];
      const range = depthRange(camera, bounds);
      const m = multiply(projectionMatrix(camera, size.width / size.height, range), viewMatrix(camera, origin));
      for (const corner of corners(bounds)) {
        const p: number[] = [...subtract(corner, origin), 1];
        const clip = [0, 1, 2, 3].map((row) => p.reduce((sum, v, column) => sum + (m[4 * column + row] ?? 0) * v, 0));
        const [x = 0, y = 0, z = 0, w = 0] = clip;
        const pixel = project(camera, corner, size);
        expect(((x / w + 1) / 2) * size.width).toBeCloseTo(pixel?.x ?? NaN, 6);
        expect(((1 - y / w) / 2) * size.height).toBeCloseTo(pixel?.y ?? NaN, 6);
        expect(Math.abs(z / w)).toBeLessThanOrEqual(1); // every corner of the box is between the near and far plane
      }
    },
  );
});
