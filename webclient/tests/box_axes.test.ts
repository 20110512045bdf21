import { describe, expect, test } from "vitest";
import { complete, project, type Bounds, type FullCamera } from "../src/model/camera";
import type { Vec3 } from "../src/model/vector";
import { overlaps } from "../src/model/overlay_room";
import { boxAxes, boxOf, keptClear, numberPlace, placeNames, type BoxAxis } from "../src/model/box_axes";

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

  const half = (text: string, em: number): { x: number; y: number } => ({
    x: (text.length * 0.62 * em) / 2,
    y: 0.375 * em,
  });
  const isInside = (label: { x: number; y: number }, text: string, em: number, of = size): boolean =>
    label.x - half(text, em).x >= 0 &&
    label.x + half(text, em).x <= of.width &&
    label.y - half(text, em).y >= 0 &&
    label.y + half(text, em).y <= of.height;
  const closeUps: [string, Vec3, Vec3][] = [
    ["whole", [4, -8, 4], [0, 0, 0]],
    ["up to the edges", [2.2, -3.4, 1.6], [0, 0, 0]],
    ["past the left edge", [2, -5, 1.5], [0.9, 0, 0]],
    ["past the right edge", [2, -5, 1.5], [-0.9, 0, 0]],
    ["past the lower edge", [2, -5, 1.5], [0, 0, 0.9]],
  ];

  test.each(closeUps)("are never cut off, however much the box fills the picture: %s", (_, position, target) => {
    for (const em of [12, 24]) {
      const axes = boxAxes(look(position, target), bounds, size, em);
      const names = axes.map(({ name }) => `${name} [cylinder diameters]`);
      expect(axes.length).toBeGreaterThan(0);
      const labels = placeNames(axes, names, size, em).filter((label) => label !== null);
      expect(labels.map(({ text }) => text)).toEqual(names);
      for (const label of labels) expect(isInside(label, label.text, em)).toBe(true);
      for (const { ticks, outward } of axes) {
        for (const tick of ticks) {
          const place = numberPlace(tick, outward, tick.label, size, em);
          expect(isInside(place, tick.label, em)).toBe(true);
          for (const label of labels) {
            const [a, b] = [half(label.text, em), half(tick.label, em)];
            const apart = Math.abs(label.x - place.x) >= a.x + b.x || Math.abs(label.y - place.y) >= a.y + b.y;
            expect(apart, `${label.text} over ${tick.label}`).toBe(true);
          }
        }
      }
    }
  });

  test("give way to what stands there, number by number, and names go where there is room", () => {
    const axes = boxAxes(look([3, -6, 3]), bounds, size);
    const names = axes.map(({ name }) => name);
    const free = keptClear(axes, size, 12, []);
    const numbers = free.flatMap(({ outward, ticks }) =>
      ticks.map((tick) => boxOf(numberPlace(tick, outward, tick.label, size, 12), tick.label, 12)),
    );
    expect(numbers.length).toBeGreaterThan(8);
    for (const [i, one] of numbers.entries())
      for (const other of numbers.slice(0, i)) expect(overlaps(one, other)).toBe(false);
    const [first] = numbers;
    if (first === undefined) return;
    const kept = keptClear(axes, size, 12, [first]).flatMap(({ ticks }) => ticks);
    expect(kept.length).toBe(numbers.length - 1);
    const all = { left: 0, top: 0, right: size.width, bottom: size.height };
    expect(keptClear(axes, size, 12, [all]).flatMap(({ ticks }) => ticks)).toEqual([]);
    expect(placeNames(axes, names, size, 12, [all])).toEqual(names.map(() => null));
    const [name] = placeNames(axes, names, size, 12);
    if (!name) throw new Error("no name");
    const elsewhere = placeNames(axes, names, size, 12, [boxOf(name, name.text, 12)])[0];
    expect(elsewhere).not.toBeNull();
    expect(Math.hypot((elsewhere?.x ?? 0) - name.x, (elsewhere?.y ?? 0) - name.y)).toBeGreaterThan(6);
  });

  test("shorten a name that is wider than the picture, and say so", () => {
    const narrow = { width: 120, height: 300 };
    const axes = boxAxes(look([3, -6, 3]), bounds, narrow);
    const [label] = placeNames(axes, ["x [cylinder diameters]"], narrow, 12);
    expect(label?.text).toMatch(/^x \[cyl.*\u2026$/);
    expect(isInside(label ?? { x: 0, y: 0 }, label?.text ?? "", 12, narrow)).toBe(true);
  });
});
