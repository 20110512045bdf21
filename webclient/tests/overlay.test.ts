import { describe, expect, test } from "vitest";
import { complete, project, type Bounds, type ViewCamera } from "../src/model/camera";
import type { Vec3 } from "../src/model/vector";
import { layOut, type AnnotatedView, type Box, type Overlay } from "../src/wasm/overlay";

const overlaps = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const size = { width: 800, height: 600 };
const bounds: Bounds = [-1, 1, -1, 1, -1, 1];
const look = (position: Vec3, target: Vec3 = [0, 0, 0], parallel = false): ViewCamera =>
  complete({ position, target, up: [0, 0, 1], fov: 30, parallel, parallel_height: 4 });

function axesOf(camera: ViewCamera, more: Partial<AnnotatedView> = {}): Overlay {
  const background: AnnotatedView["background"] = { top: [0, 0, 0], bottom: [0, 0, 0] };
  const others = { triad: false, axes: true, lengthUnits: "m", taken: [] };
  return layOut({ size, text: 12, camera, bounds, background, ...others, ...more }).axes;
}

const texts = ({ labels }: Overlay): string[] => labels.map(({ text }) => text);
const names = (overlay: Overlay): string[] => texts(overlay).filter((text) => /^[xyz]/.test(text));

function expectClear({ labels }: Overlay, within = size, taken: readonly Box[] = []): void {
  for (const [i, { text, box }] of labels.entries()) {
    expect(box.left >= 0 && box.right <= within.width, `${text} is cut off`).toBe(true);
    expect(box.top >= 0 && box.bottom <= within.height, `${text} is cut off`).toBe(true);
    for (const other of [...labels.slice(0, i).map((label) => label.box), ...taken])
      expect(overlaps(box, other), `${text} covers something`).toBe(false);
  }
}

describe("the axes of the box", () => {
  test.each([false, true])("are the lower silhouette edges and the left one (parallel: %s)", (parallel) => {
    const camera = look([4, -8, 4], [0, 0, 0], parallel);
    const overlay = axesOf(camera);
    expect(names(overlay)).toEqual(["x [m]", "y [m]", "z [m]"]);
    const edges: [Vec3, Vec3][] = [
      [
        [-1, -1, -1],
        [1, -1, -1],
      ],
      [
        [1, -1, -1],
        [1, 1, -1],
      ],
      [
        [-1, -1, -1],
        [-1, -1, 1],
      ],
    ];
    for (const [i, [low, high]] of edges.entries()) {
      const stroke = overlay.strokes[i];
      for (const [place, corner] of [
        [stroke?.from, low],
        [stroke?.to, high],
      ] as const) {
        expect(place?.x).toBeCloseTo(project(camera, corner, size)?.x ?? NaN, 6);
        expect(place?.y).toBeCloseTo(project(camera, corner, size)?.y ?? NaN, 6);
      }
    }
    const numbers = texts(overlay).filter((text) => !/^[xyz]/.test(text));
    expect(numbers.length).toBeGreaterThanOrEqual(5);
    for (const number of numbers)
      expect(Math.abs(Number(number.replace("\u2212", "-"))), number).toBeLessThanOrEqual(1);
    expectClear(overlay);
  });

  test("are two where a face is seen from the front", () => {
    expect(names(axesOf(look([0, -6, 0])))).toEqual(["x [m]", "z [m]"]);
  });

  test("are none from inside, nor behind the eye", () => {
    expect(axesOf(look([0, -0.5, 0.2])).strokes).toEqual([]);
    expect(axesOf(look([0, -6, 0], [0, -12, 0])).strokes).toEqual([]);
  });

  test("of a flat box are those that have a length", () => {
    expect(names(axesOf(look([0, -6, 3]), { bounds: [-1, 1, -1, 1, 0, 0] }))).toEqual(["x [m]", "y [m]"]);
  });

  const closeUps: [string, Vec3, Vec3][] = [
    ["whole", [4, -8, 4], [0, 0, 0]],
    ["up to the edges", [2.2, -3.4, 1.6], [0, 0, 0]],
    ["past the left edge", [2, -5, 1.5], [0.9, 0, 0]],
    ["past the right edge", [2, -5, 1.5], [-0.9, 0, 0]],
    ["past the lower edge", [2, -5, 1.5], [0, 0, 0.9]],
  ];
  test.each(closeUps)("are never cut off, however much the box fills the picture: %s", (_, position, target) => {
    for (const text of [12, 24]) {
      const overlay = axesOf(look(position, target), { text, lengthUnits: "cylinder diameters" });
      expect(names(overlay).length).toBeGreaterThan(0);
      expect(overlay.labels.length).toBeGreaterThan(names(overlay).length);
      expectClear(overlay);
    }
  });

  test("give way to what stands there, number by number, and names go where there is room", () => {
    const camera = look([3, -6, 3]);
    const free = axesOf(camera);
    const [number] = free.labels;
    const name = free.labels.find(({ text }) => text.startsWith("x"));
    if (number === undefined || name === undefined) throw new Error("no labels");
    expectClear(axesOf(camera, { taken: [number.box] }), size, [number.box]);
    const moved = axesOf(camera, { taken: [name.box] });
    expectClear(moved, size, [name.box]);
    expect(names(moved)).toContain("x [m]");
    const all = { left: 0, top: 0, right: size.width, bottom: size.height };
    expect(axesOf(camera, { taken: [all] }).labels).toEqual([]);
  });

  test("shorten a name that is wider than the picture, and say so", () => {
    const narrow = { width: 120, height: 300 };
    const overlay = axesOf(look([3, -6, 3]), { size: narrow, lengthUnits: "cylinder diameters" });
    expect(names(overlay).some((name) => /^[xyz] \[cyl.*\u2026$/.test(name))).toBe(true);
    expectClear(overlay, narrow);
  });
});

describe("the triad", () => {
  test("stands at the lower left, keeps off other overlays, and shows how the camera looks", () => {
    const view = { axes: false, triad: true };
    const triadOf = (taken: Box[]): Overlay =>
      layOut({
        size,
        text: 12,
        camera: look([0, -6, 0]),
        bounds,
        background: { top: [0, 0, 0], bottom: [0, 0, 0] },
        lengthUnits: "",
        taken,
        ...view,
      }).triad;
    const triad = triadOf([]);
    const places = Object.fromEntries(triad.labels.map(({ text, at }) => [text, at]));
    expect(places.x?.x).toBeGreaterThan(places.z?.x ?? NaN);
    expect(places.z?.y).toBeLessThan(places.x?.y ?? NaN);
    for (const { box } of triad.labels) expect(box.right < 120 && box.top > size.height - 120).toBe(true);
    expect(triadOf([{ left: 20, top: 560, right: 40, bottom: 580 }]).labels).toEqual([]);
  });
});
