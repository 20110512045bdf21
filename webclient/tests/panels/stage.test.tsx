// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { Coloring, Scene } from "../../src/generated/protocol";
import type { Histogram, Probe } from "../../src/model/state";
import { ProbeCard } from "../../src/panels/stage/probe_card";
import { Texts } from "../../src/panels/stage/texts";
import { stand, type Stand } from "./stand";

const probe: Probe = {
  result: {
    hit: true,
    position: [0.5, 0.5, 0.5],
    vertex: 1,
    cell: 4,
    layer: "wall",
    patch: "inlet",
    values: { p: 1.5, T: null },
  },
  time: 0,
};

describe("the card of a probe", () => {
  const scene: Scene = {
    dataset: "box",
    camera: { position: [0.5, -9, 0.5], target: [0.5, 0.5, 0.5] },
    layers: { wall: { type: "surface" } },
  };

  test("hides its patch, shows only its patch, copies its values and closes", () => {
    const { calls, click } = stand(<ProbeCard />, scene, { probe });
    for (const button of ["Hide", "Only this", "Copy the values", "Close the values"]) click(button);
    expect(calls).toEqual([
      ["layers.hidePatch", "wall", "inlet"],
      ["layers.onlyPatch", "wall", "inlet"],
      ["probe.copy"],
      ["probe.close"],
    ]);
  });

  test("tells the values, and marks the point where the camera sees it", () => {
    const { change, model, root } = stand(<ProbeCard />, scene, { probe, canvasSize: { width: 200, height: 100 } });
    expect([...root.querySelectorAll("dd")].map((one) => one.textContent)).toEqual(["1.5 Pa", "no value here"]);
    const mark = (): string => root.querySelector<HTMLElement>(".probe-mark")?.style.left ?? "";
    expect(mark()).toBe("100px");
    change(
      () => void (model.scene.value = { ...scene, camera: { position: [1.5, -9, 0.5], target: [1.5, 0.5, 0.5] } }),
    );
    expect(parseFloat(mark())).toBeLessThan(100);
    change(() => void (model.probe.value = null));
    expect(root.textContent).toBe("");
  });
});

const histogram: Histogram = { range: [-2, 8], counts: [1, 2, 3], invalid: 0 };
const legends = (color: Partial<Coloring> = {}, scene: Partial<Scene> = {}): Stand =>
  stand(
    <Texts />,
    {
      dataset: "box",
      time: 0,
      layers: { iso: { type: "iso", array: "T", values: [3], color: { array: "p", ...color } } },
      ...scene,
    },
    {},
    { histogram },
  );
const of = { layers: ["iso"], contours: [] };
/** Calls without those that tell where the texts stand. */
const acts = ({ calls }: Stand): Stand["calls"] => calls.filter(([name]) => !name.startsWith("page."));

describe("legends", () => {
  test("take a number that is typed at an end", () => {
    const shown = legends();
    shown.type("Highest value of the p colors", "5");
    shown.type("Lowest value of the p colors", "0");
    expect(acts(shown)).toEqual([
      ["colors.set", of, { range: [-2, 5] }],
      ["colors.set", of, { range: [0, 8] }],
    ]);
  });

  test("refuse an end that a logarithmic scale cannot have", () => {
    const shown = legends({ log: true, range: [1, 8] });
    shown.type("Lowest value of the p colors", "0");
    expect(acts(shown)).toEqual([["tell", expect.stringContaining("above zero"), "error"]]);
  });

  test("hold the range of all steps by the pin, and follow the data again", () => {
    const free = legends();
    expect(free.root.textContent).toContain("this step");
    free.click("The same range at every step for p");
    expect(acts(free)).toEqual([["colors.set", of, { range: [0, 10] }]]);
    const held = legends({ range: [1, 2] });
    expect(held.root.textContent).toContain("held");
    held.click("Range of the data for p");
    expect(acts(held)).toEqual([["colors.set", of, { range: undefined }]]);
    expect(legends({ range: [0, 10] }).root.textContent).toContain("all steps");
  });

  test("become symmetric about zero", () => {
    const shown = legends();
    shown.click("Range symmetric about zero for p");
    expect(acts(shown)).toEqual([["colors.set", of, { range: [-8, 8] }]]);
  });
});

describe("places of the texts", () => {
  test("tell where they stand, also when they are gone", () => {
    const { calls, change, model, root } = legends();
    expect(calls.map(([name]) => name)).toEqual(["page.covered", "page.legendsStand"]);
    expect(calls[1]?.[1]).toHaveLength(1);
    change(() => void (model.scene.value = { dataset: "box", layers: {} }));
    expect(root.querySelector(".legend")).toBeNull();
    expect(calls.at(-1)).toEqual(["page.legendsStand", []]);
  });

  test("stand beside the title and the captions, which are read aloud", () => {
    const annotations = { title: "Wing", dataset: true, time: true };
    const { root } = legends({}, { annotations, time: 0.5 });
    const drawn = [...root.querySelectorAll(".texts text")].map((text) => text.textContent);
    expect(drawn).toEqual(expect.arrayContaining(["Wing", "box", "Time: 0.5"]));
    const read = [...root.querySelectorAll(".for-readers > *")].map((text) => text.textContent);
    expect(read).toEqual(["Wing", "box", "Time: 0.5"]);
  });

  test("keep the range of the step before until that of the new step arrives", () => {
    const shown = legends();
    const field = shown.find("Highest value of the p colors");
    shown.answer("histogram", null);
    shown.change(() => void (shown.model.scene.value = { ...shown.model.scene.value, dataset: "box", time: 1 }));
    expect(shown.find("Highest value of the p colors")).toBe(field);
    expect(shown.root.querySelectorAll(".legend")).toHaveLength(1);
  });

  test("do not tell where they stand before their range is known", () => {
    const waiting = legends();
    const before = waiting.calls.length;
    waiting.answer("histogram", null);
    const layers: Scene["layers"] = { iso: { type: "iso", array: "T", values: [3], color: { array: "T" } } };
    waiting.change(() => void (waiting.model.scene.value = { dataset: "box", layers }));
    expect(waiting.root.querySelector(".legend")).toBeNull();
    expect(waiting.calls.slice(before).map(([name]) => name)).not.toContain("page.legendsStand");
  });
});
