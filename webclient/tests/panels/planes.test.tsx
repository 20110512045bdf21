// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { ClipLayer, Contours, Scene, SliceLayer } from "../../src/generated/protocol";
import { ClipSection } from "../../src/panels/layers/clip_section";
import { DatasetSection } from "../../src/panels/layers/dataset_section";
import { LayersSection } from "../../src/panels/layers/layers_section";
import { SlicesSection } from "../../src/panels/layers/slices_section";
import { described, stand, type Stand } from "./stand";

const clips = (layers: Record<string, ClipLayer>, answers: Record<string, unknown> = {}): Stand =>
  stand(<ClipSection />, { dataset: "box", layers } satisfies Scene, {}, answers);

const LOOKING_UP_X = { position: [-9, 0, 0], target: [0, 0, 0], up: [0, 0, 1], fov: 30, parallel: false };

describe("clips", () => {
  test("are added in the middle, with caps that are colored", () => {
    const { calls, click } = clips({});
    click("Add a clip across y");
    click("Add a free clip plane");
    const color = { array: "p" };
    expect(calls).toEqual([
      ["layers.add", "clip-y", { type: "clip", axis: "y", value: 0.5, color }],
      ["layers.add", "clip", { type: "clip", origin: [0.5, 0.5, 0.5], normal: [1, 1, 0], color }],
    ]);
  });

  test("keep the half that does not hide the cut from the camera", () => {
    const { calls, click } = clips({}, { "camera.get": LOOKING_UP_X });
    click("Add a clip across x");
    expect(calls).toEqual([["layers.add", "clip-x", expect.objectContaining({ axis: "x", invert: true })]]);
  });

  test("are switched off, removed, turned round and capped", () => {
    const { calls, click } = clips({ cut: { type: "clip", axis: "x", value: 0.5 } });
    click("Switch this clip off");
    click("Other side");
    click("Caps in colors of their own");
    click("Caps");
    click("Remove this clip");
    expect(calls).toEqual([
      ["layers.set", "cut", { visible: false }],
      ["layers.set", "cut", { invert: true }],
      ["layers.set", "cut", { color: { array: "p" } }],
      ["layers.set", "cut", { caps: false }],
      ["layers.remove", "cut"],
    ]);
  });

  test("slide along their axis as one gesture, and take a position", () => {
    const { calls, slide, type } = clips({ cut: { type: "clip", axis: "x", value: 0.5 } });
    slide("Position of the x clip", 0.6, 0.7);
    type("Clip position on x", "0.25");
    expect(calls).toEqual([
      ["layers.set", "cut", { value: 0.6 }, "gesture-1"],
      ["layers.set", "cut", { value: 0.7 }, "gesture-1"],
      ["layers.set", "cut", { value: 0.25 }, undefined],
    ]);
  });

  test("of a free plane have a normal, which is never zero, and turn to the view", () => {
    const free = { cut: { type: "clip", origin: [0.5, 0.5, 0.5], normal: [1, 0, 0] } satisfies ClipLayer };
    const { calls, click, slide, type } = clips(free, { "camera.get": LOOKING_UP_X });
    type("Normal x", "0");
    type("Normal y", "1");
    type("Origin z", "0.25");
    slide("Position along the normal", 0.25);
    click("Turn the plane to face the view");
    expect(calls).toEqual([
      ["tell", expect.stringContaining("no direction"), "error"],
      ["layers.set", "cut", { normal: [1, 1, 0] }],
      ["layers.set", "cut", { origin: [0.5, 0.5, 0.25] }],
      ["layers.set", "cut", { origin: [0.75, 0.5, 0.5] }, "gesture-1"],
      ["layers.set", "cut", { origin: [0.5, 0.5, 0.5], normal: [-1, 0, 0] }],
    ]);
  });

  test("are six at most", () => {
    const six = Object.fromEntries([1, 2, 3, 4, 5, 6].map((n) => [`cut${n}`, { type: "clip", axis: "x" } as const]));
    const { find } = clips(six);
    expect((find("Add a clip across x") as HTMLButtonElement).disabled).toBe(true);
  });
});

describe("slices", () => {
  const slices = (layers: Record<string, SliceLayer>): Stand => stand(<SlicesSection />, { dataset: "box", layers });

  test("are added, and lie across another axis when that is chosen", () => {
    const { calls, choose, click } = slices({ cut: { type: "slice", axis: "z", value: 0.5, color: { array: "p" } } });
    click("Add a slice across x");
    choose("Plane of the slice", "x");
    expect(calls).toEqual([
      ["layers.add", "slice-x", { type: "slice", axis: "x", value: 0.5, color: { array: "T" } }],
      ["layers.set", "cut", expect.objectContaining({ axis: "x", value: 0.5 })],
    ]);
  });

  test("take the looks of another", () => {
    const { calls, click } = slices({ a: { type: "slice", axis: "z", opacity: 0.5 }, b: { type: "slice", axis: "x" } });
    click("All slices like this one");
    expect(calls).toEqual([["layers.setAll", { b: { opacity: 0.5 } }]]);
  });
});

describe("contour lines", () => {
  const lines = (contours?: Contours): Stand => {
    const cut: SliceLayer = { type: "slice", axis: "z", color: { array: "p" }, ...(contours && { contours }) };
    return stand(<SlicesSection />, { dataset: "box", layers: { cut } });
  };
  const changes = (calls: Stand["calls"]): unknown[] =>
    calls.map(([name, id, change]) => [name, id, (change as SliceLayer).contours]);

  test("are switched on with the array of the slice, and off", () => {
    const none = lines();
    none.click("Contour lines");
    expect(changes(none.calls)).toEqual([["layers.set", "cut", { array: "p", visible: true }]]);
    const some = lines({ array: "p" });
    some.click("Contour lines");
    expect(changes(some.calls)).toEqual([["layers.set", "cut", { visible: false }]]);
  });

  test("are of an array, at even values in a range", () => {
    const { calls, choose, type } = lines({ array: "p" });
    type("Number of contour lines", "4");
    type("Contour lines from", "2");
    choose("Lines of", "T");
    expect(changes(calls)).toEqual([
      ["layers.set", "cut", { count: 4 }],
      ["layers.set", "cut", { range: [2, 10] }],
      ["layers.set", "cut", { array: "T", values: null, range: null }],
    ]);
  });

  test("are at own values, first those that were even", () => {
    const even = lines({ array: "p", count: 4 });
    even.choose("Lines at", "own");
    expect(changes(even.calls)).toEqual([["layers.set", "cut", { values: [2, 4, 6, 8], count: null, range: null }]]);
    const own = lines({ array: "p", values: [2, 4] });
    own.type("Contour value 1", "3");
    own.click("Remove contour value 2");
    own.click("Add a contour value");
    expect(changes(own.calls)).toEqual([
      ["layers.set", "cut", { values: [3, 4] }],
      ["layers.set", "cut", { values: [2] }],
      ["layers.set", "cut", { values: [2, 4, 7] }],
    ]);
  });

  test("have a color and a width, or the colors of their values", () => {
    const { calls, choose, click, type } = lines({ array: "p" });
    choose("Color of the contour lines", "#ff0000");
    type("Width of the contour lines in pixels", "3");
    click("Lines in the colors of their values");
    expect(changes(calls)).toEqual([
      ["layers.set", "cut", { color: "#ff0000" }],
      ["layers.set", "cut", { width: 3 }],
      ["layers.set", "cut", { coloring: { map: "inferno" } }],
    ]);
  });
});

test("layers are dragged to another place", () => {
  // Preact finds the names of events by these members, which the fake page lacks.
  for (const name of ["ondragstart", "ondragover", "ondrop"])
    Object.defineProperty(HTMLElement.prototype, name, { value: null, configurable: true });
  const { calls, change, click, root } = stand(<LayersSection />, {
    dataset: "box",
    layers: { a: { type: "outline", order: 0 }, b: { type: "points", order: 1 }, c: { type: "edges", order: 2 } },
  });
  click("Layers");
  const [first, , last] = root.querySelectorAll("li");
  const send = (row: Element | undefined, type: string, clientY = 0): void =>
    change(() => void row?.dispatchEvent(new MouseEvent(type, { clientY, bubbles: true, cancelable: true })));
  send(first, "dragstart");
  send(last, "dragover", 1); // the fake page has no layout: below the middle of a row without height
  expect(last?.className).toContain("below");
  send(last, "drop");
  expect(calls).toEqual([["layers.move", "a", 2]]);
});

describe("the dataset", () => {
  test("unfolds its facts", () => {
    const { click, root } = stand(<DatasetSection />, { dataset: "box" });
    expect(root.textContent).toContain("from box.vtu");
    expect(root.querySelector("dl")).toBeNull();
    click("Dataset");
    expect(root.textContent).toContain("Boundary faces6");
    expect([...root.querySelectorAll("tbody tr")].map((row) => row.textContent)).toEqual([
      expect.stringMatching(/^p.*0 to 10Pa$/),
      expect.stringMatching(/^T.*200 to 400K$/),
    ]);
  });

  test("has units with superscripts", () => {
    const [p] = described.arrays;
    const description = { ...described, arrays: p === undefined ? [] : [{ ...p, units: "m^2/s^2" }] };
    const { click, root } = stand(<DatasetSection />, { dataset: "box" }, { description });
    click("Dataset");
    expect(root.querySelector("tbody tr")?.textContent).toContain("m²/s²");
  });
});
