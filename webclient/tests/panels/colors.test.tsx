// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { ColorPoint, Scene } from "../../src/generated/protocol";
import { ColoringFields, OpacityField } from "../../src/panels/color/coloring";
import { ColorScalePanel } from "../../src/panels/color/color_scale_panel";
import type { ScaledColoring } from "../../src/model/scalars";
import { stand, type Stand } from "./stand";

const scene: Scene = { dataset: "box", time: 0, layers: {} };
const of = { layers: ["iso"] };

describe("coloring", () => {
  test("is by an array or in one color", () => {
    const { calls, choose } = stand(<ColoringFields of={of} coloring={{ array: "p" }} />, scene);
    choose("Color by", "T");
    choose("Color by", "");
    expect(calls).toEqual([
      ["colors.by", of, "T"],
      ["colors.by", of, null],
    ]);
  });

  test("has a color or a map that is chosen", () => {
    const plain = stand(<ColoringFields of={of} coloring={{}} />, scene);
    plain.choose("Color", "#ff0000");
    expect(plain.calls).toEqual([["colors.set", of, { solid: "#ff0000" }]]);
    const mapped = stand(<ColoringFields of={of} coloring={{ array: "p" }} />, scene);
    mapped.choose("Map", "inferno");
    expect(mapped.calls).toEqual([["colors.set", of, { map: "inferno", points: undefined }]]);
  });

  test("has an opacity that follows the slider as one gesture", () => {
    const { calls, slide } = stand(<OpacityField id="iso" opacity={1} />, scene);
    slide("Opacity", 80, 50);
    expect(calls).toEqual([
      ["layers.set", "iso", { opacity: 0.8 }, "gesture-1"],
      ["layers.set", "iso", { opacity: 0.5 }, "gesture-1"],
    ]);
  });

  test("tells why its layer shows nothing", () => {
    const empty = [{ layer: "iso", why: "clipped" as const, reason: "A clip cuts it away." }];
    const { root } = stand(<OpacityField id="iso" opacity={1} />, scene, { empty });
    expect(root.textContent).toContain("A clip cuts it away.");
  });
});

function scalePanel(coloring: Partial<ScaledColoring> = {}, answers: Record<string, unknown> = {}): Stand {
  const panel = <ColorScalePanel of={of} coloring={{ array: "p", ...coloring }} data={[0, 10]} />;
  const shown = stand(panel, scene, {}, answers);
  shown.click("Color scale of p");
  return shown;
}

describe("the color scale", () => {
  test("takes a map, a direction and steps", () => {
    const { calls, click } = scalePanel();
    click("Color map inferno");
    click("Reverse");
    click("Symmetric");
    click("Symmetric log");
    click("Steps");
    expect(calls).toEqual([
      ["colors.set", of, { map: "inferno", points: undefined }, undefined],
      ["colors.set", of, { reverse: true }, undefined],
      ["colors.set", of, { symmetric: true, log: undefined }, undefined],
      ["colors.set", of, { symmetric: true, log: true }, undefined],
      ["colors.set", of, { steps: 10 }, undefined],
    ]);
  });

  test("switches the logarithm by its own command, which remembers", () => {
    const { calls, click } = scalePanel({ range: [1, 10] });
    click("Logarithmic");
    expect(calls).toEqual([["colors.setLog", of, { array: "p", range: [1, 10] }, true]]);
  });

  test("takes a number of steps within its limits", () => {
    const { calls, type } = scalePanel({ steps: 10 });
    type("Number of steps", "1");
    expect(calls).toEqual([
      ["tell", expect.stringContaining("from 2 to 256")],
      ["colors.set", of, { steps: 2 }, undefined],
    ]);
  });

  test("takes an end of the range, and refuses one that a logarithm cannot have", () => {
    const linear = scalePanel();
    linear.type("Range from", "2");
    expect(linear.calls).toEqual([["colors.set", of, { range: [2, 10] }, undefined]]);
    const logarithmic = scalePanel({ log: true, range: [1, 10] });
    logarithmic.type("Range from", "-1");
    expect(logarithmic.calls).toEqual([["tell", expect.stringContaining("above zero"), "error"]]);
  });

  test("takes the range in view, of most values, of the data and of all times", async () => {
    const ranges = { "colors.rangeInView": Promise.resolve([3, 4]), "colors.usualRange": Promise.resolve(null) };
    const { calls, click } = scalePanel({ range: [1, 2] }, ranges);
    for (const button of ["In view", "1–99 %", "Data", "All times"]) click(button);
    await Promise.all(Object.values(ranges));
    expect(calls).toEqual([
      ["colors.rangeInView", of],
      ["colors.usualRange", "p"],
      ["colors.set", of, { range: undefined }, undefined],
      ["colors.set", of, { range: [0, 10] }, undefined],
      ["colors.set", of, { range: [3, 4] }, undefined], // no range of most values: nothing is set
    ]);
  });

  test("takes colors of values outside the range", () => {
    const { calls, click, choose } = scalePanel({ above: "#ffffff" });
    click("Below the range");
    choose("Color of values above the range", "#00ff00");
    choose("Color of missing values", "#0000ff");
    expect(calls).toEqual([
      ["colors.set", of, { below: expect.stringMatching(/^#/) as string }, undefined],
      ["colors.set", of, { above: "#00ff00" }, undefined],
      ["colors.set", of, { nan: "#0000ff" }, undefined],
    ]);
  });
});

describe("own colors", () => {
  const points: ColorPoint[] = [
    { at: 0, color: "#000000" },
    { at: 0.5, color: "#ff0000" },
    { at: 1, color: "#ffffff" },
  ];
  const places = (calls: Stand["calls"]): unknown[] =>
    calls.map(([, , change, gesture]) => [(change as { points: ColorPoint[] }).points.map(({ at }) => at), gesture]);

  test("begin with those of the map", () => {
    const { calls, click } = scalePanel();
    click("Colors of my own");
    expect(places(calls)).toEqual([[[0, 0.25, 0.5, 0.75, 1], undefined]]);
  });

  test("are dragged along the bar, no farther than their neighbors", () => {
    const { calls, drag } = scalePanel({ points });
    drag("Place of color 2", [50, 50], [70, 50], [200, 50]);
    expect(places(calls)).toEqual([
      [[0, 0.7, 1], "gesture-1"],
      [[0, 1, 1], "gesture-1"],
    ]);
  });

  test("are dragged the other way on a reversed scale", () => {
    const { calls, drag } = scalePanel({ points, reverse: true });
    drag("Place of color 2", [50, 50], [70, 50]);
    expect(places(calls)).toEqual([[[0, 0.3, 1], "gesture-1"]]);
  });

  test("move by keys and by typed values", () => {
    const { calls, key, type } = scalePanel({ points });
    key("Place of color 2", "ArrowRight");
    type("Value of color 2", "8");
    expect(places(calls)).toEqual([
      [[0, 0.51, 1], "gesture-1"],
      [[0, 0.8, 1], undefined],
    ]);
  });

  test("are chosen, added and removed", () => {
    const { calls, click, choose } = scalePanel({ points });
    choose("Color 1", "#00ff00");
    click("Add a color");
    click("Remove color 2");
    expect(calls[0]?.[2]).toEqual({ points: [{ at: 0, color: "#00ff00" }, ...points.slice(1)] });
    expect(places(calls.slice(1))).toEqual([
      [[0, 0.25, 0.5, 1], undefined],
      [[0, 1], undefined],
    ]);
  });
});
