// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { IsoSection } from "../../src/panels/layers/iso_section";
import { LayersSection } from "../../src/panels/layers/layers_section";
import { SlicesSection } from "../../src/panels/layers/slices_section";
import { LightingSection } from "../../src/panels/look/lighting_section";
import { Help } from "../../src/panels/shell/help";
import { Toolbar } from "../../src/panels/shell/toolbar";
import { TimeBar } from "../../src/panels/time/time_bar";
import { makeModel } from "../../src/model/model";
import { recordedCommands, stand } from "./stand";

const scene: Scene = {
  dataset: "box",
  time: 0,
  layers: {
    iso: { type: "iso", array: "p", values: [2, 4], order: 0 },
    cut: { type: "slice", axis: "z", value: 0.5, order: 1 },
  },
};

describe("the recorder of commands", () => {
  const model = makeModel();

  test("has the names of the real commands only", () => {
    const commands = recordedCommands(model, []) as unknown as Record<string, Record<string, unknown>>;
    expect(() => commands.camera?.reset).not.toThrow();
    expect(() => commands.camera?.rest).toThrow("Commands has no camera.rest");
    expect(() => commands.cameras).toThrow("Commands has no cameras");
  });

  test("takes no answer of a command that does not exist", () => {
    expect(() => recordedCommands(model, [], { "layers.append": 1 })).toThrow("Commands has no layers.append");
  });
});

describe("iso-surfaces", () => {
  test("are hidden, removed and added by their buttons", () => {
    const { calls, click } = stand(<IsoSection />, scene);
    click("Hide this iso-surface");
    click("Remove this iso-surface");
    click("Add an iso-surface");
    expect(calls).toEqual([
      ["layers.set", "iso", { visible: false }],
      ["layers.remove", "iso"],
      ["layers.add", "iso", expect.objectContaining({ type: "iso", array: "T", values: [5] })],
    ]);
  });

  test("take a value that is typed, and lose one", () => {
    const { calls, click, type } = stand(<IsoSection />, scene);
    type("Value 1", "3");
    click("Remove value 2");
    expect(calls).toEqual([
      ["layers.set", "iso", { values: [3, 4] }, undefined],
      ["layers.set", "iso", { values: [2] }, undefined],
    ]);
  });

  test("say what is no number, and change nothing", () => {
    const { calls, type } = stand(<IsoSection />, scene);
    type("Value 1", "three");
    expect(calls).toEqual([["tell", expect.stringContaining("three"), "error"]]);
  });

  test("follow the keys on a handle of the slider", () => {
    const { calls, key } = stand(<IsoSection />, scene);
    key("p, value 1", "ArrowRight");
    expect(calls.length).toBe(1);
    const [name, id, change, gesture] = calls[0] ?? [];
    expect([name, id, gesture]).toEqual(["layers.set", "iso", "gesture-1"]);
    expect((change as { values: number[] }).values[0]).toBeGreaterThan(2);
    expect((change as { values: number[] }).values[1]).toBe(4);
  });

  test("follow the pointer on a handle, no farther than the track", () => {
    const { calls, drag } = stand(<IsoSection />, scene);
    drag("p, value 1", [20, 50], [30, 50], [35, 50]);
    drag("p, value 2", [40, 50], [500, 50]);
    expect(calls).toEqual([
      ["layers.set", "iso", { values: [3, 4] }, "gesture-1"],
      ["layers.set", "iso", { values: [3.5, 4] }, "gesture-1"],
      ["layers.set", "iso", { values: [2, 10] }, "gesture-1"],
    ]);
  });

  test("of another array begin in the middle of it", () => {
    const { calls, choose } = stand(<IsoSection />, scene);
    choose("Array of the iso-surface", "T");
    expect(calls).toEqual([["layers.set", "iso", { array: "T", values: [5] }]]);
  });
});

describe("layers", () => {
  test("are moved by their buttons", () => {
    const { calls, click } = stand(<LayersSection />, scene);
    click("Layers");
    click("Move this layer down");
    expect(calls).toEqual([["layers.move", "iso", 1]]);
  });

  test("are drawn again when the scene has others", () => {
    const { model, root, change, click } = stand(<LayersSection />, scene);
    click("Layers");
    expect(root.querySelectorAll("li").length).toBe(2);
    change(() => void (model.scene.value = { ...scene, layers: {} }));
    expect(root.querySelectorAll("li").length).toBe(0);
  });
});

describe("time", () => {
  test("steps, plays and loops", () => {
    const { calls, click, model, change } = stand(<TimeBar />, scene);
    click("Step on");
    click("Play");
    change(() => void (model.playing.value = true));
    click("Pause");
    expect(calls).toEqual([["time.stepBy", 1], ["time.togglePlay"], ["time.togglePlay"]]);
  });

  test("is no matter of a dataset with one step", () => {
    const { root, change, model } = stand(<TimeBar />, scene);
    change(() => void (model.description.value = { ...(model.description.value ?? ({} as never)), times: [0] }));
    expect(root.textContent).toContain("one time step");
  });
});

describe("the toolbar", () => {
  test("undoes what can be undone", () => {
    const { calls, click, find, change, model } = stand(<Toolbar />, scene, { canUndo: true });
    expect((find("Redo") as HTMLButtonElement).disabled).toBe(true);
    click("Undo");
    change(() => void (model.canRedo.value = true));
    click("Redo");
    expect(calls).toEqual([["undo"], ["redo"]]);
  });

  test("opens the help and the panel", () => {
    const { calls, click } = stand(<Toolbar />, scene);
    click("Help");
    expect(calls).toEqual([["page.showHelp", true]]);
  });
});

test("the help closes by its button", () => {
  const { calls, click } = stand(<Help />, scene, { helpOpen: true });
  click("Close");
  expect(calls[0]).toEqual(["page.showHelp", false]);
});

test("the lights are switched", () => {
  const { calls, click } = stand(<LightingSection />, scene);
  click("Lighting");
  click("Lights");
  expect(calls).toEqual([["change", { lighting: { on: false } }, undefined]]);
});

test("a slice is removed", () => {
  const { calls, click } = stand(<SlicesSection />, scene);
  click("Remove this slice");
  expect(calls).toEqual([["layers.remove", "cut"]]);
});
