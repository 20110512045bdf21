import { expect, test } from "vitest";
import {
  DEFAULT_OPACITY,
  firstOpacity,
  inserted,
  keyedPoint,
  middleOfGap,
  moved,
  removed,
  type OpacityPoint,
} from "../src/model/opacity";

const points: OpacityPoint[] = [
  [0.2, 0.1],
  [0.5, 0.8],
  [0.9, 0.3],
];

test("a point stays between its neighbours and inside the picture", () => {
  expect(moved(points, 1, [0.1, 2])).toEqual([
    [0.2, 0.1],
    [0.2, 1],
    [0.9, 0.3],
  ]);
  expect(moved(points, 1, [0.95, -1])[1]).toEqual([0.9, 0]);
  expect(moved(points, 0, [-3, 0.5])[0]).toEqual([0, 0.5]);
  expect(moved(points, 2, [3, 0.5])[2]).toEqual([1, 0.5]);
});

test("a new point is put in the order of positions", () => {
  expect(inserted(points, [0.6, 0.5])).toEqual([[points[0], points[1], [0.6, 0.5], points[2]], 2]);
  expect(inserted(points, [0, 0])[1]).toBe(0);
  expect(inserted(points, [1, 0])[1]).toBe(3);
  expect(inserted(points, [0.5, 0])[1]).toBe(2);
});

test("the last point cannot be removed", () => {
  expect(removed(points, 1)).toEqual([points[0], points[2]]);
  expect(removed([[0.3, 0.4]], 0)).toEqual([[0.3, 0.4]]);
});

test("a further point goes into the widest gap, on the curve", () => {
  const [position, opacity] = middleOfGap(points);
  expect(position).toBeCloseTo(0.7);
  expect(opacity).toBeCloseTo(0.55);
  expect(middleOfGap(DEFAULT_OPACITY)).toEqual([0.5, 0.45]);
});

test("arrow keys move a point, ten times as far with shift", () => {
  expect(keyedPoint("ArrowUp", false, [0.5, 0.5])).toEqual([0.5, 0.51]);
  expect(keyedPoint("ArrowLeft", true, [0.5, 0.5])).toEqual([0.4, 0.5]);
  expect(keyedPoint("a", false, [0.5, 0.5])).toBeNull();
});

test("a first curve lets the eye in: what fills most of the mesh is clear, the rare ends are not", () => {
  const most = (at: number, counts: readonly number[]): number => {
    const points = firstOpacity(counts);
    const next = points.findIndex(([position]) => position >= at);
    const a: OpacityPoint = points[Math.max(0, next - 1)] ?? [0, 0];
    const b: OpacityPoint = points[next] ?? [1, 0];
    return b[0] === a[0] ? b[1] : a[1] + ((at - a[0]) / (b[0] - a[0])) * (b[1] - a[1]);
  };
  const stream = [1, 1, 1, 2, 2, 3, 80, 400, 20, 1]; // histogram of a flow: most values at 0.75, a wake with lower ones
  expect(most(0.75, stream)).toBeLessThan(0.02);
  expect(most(0, stream)).toBeGreaterThan(0.3);
  const dye = [900, 20, 10, 10, 10, 10, 10, 10, 10, 10]; // histogram of a dye that is absent in most of the mesh
  expect(most(0.05, dye)).toBeLessThan(0.02);
  expect(most(1, dye)).toBeGreaterThan(0.3);
  const signed = [1, 2, 30, 900, 900, 30, 2, 1];
  expect([most(0, signed), most(1, signed)].every((opacity) => opacity > 0.3)).toBe(true);
  expect(most(0.5, signed)).toBeLessThan(0.02);
});

test("a first curve of unknown values rises gently, and every one is in order", () => {
  for (const counts of [null, [], [0, 0], [7], [1, 1, 1, 1]]) {
    const positions = firstOpacity(counts).map(([position]) => position);
    expect(positions).toEqual([...positions].sort((a, b) => a - b));
    expect(positions).toContain(0);
    expect(positions).toContain(1);
  }
});
