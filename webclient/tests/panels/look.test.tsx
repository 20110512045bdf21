// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { complete, type ViewCamera } from "../../src/model/camera";
import { CameraSection } from "../../src/panels/look/camera_section";
import { ViewSection } from "../../src/panels/look/view_section";
import { stand, type Stand } from "./stand";

const scene: Scene = {
  dataset: "box",
  camera: { position: [0, -10, 0], target: [0, 0, 0], up: [0, 0, 1] },
  layers: {},
};

describe("the view", () => {
  test("has a background and a stream", () => {
    const { calls, choose } = stand(<ViewSection />, scene);
    choose("Background", "light");
    choose("Background", "custom");
    choose("Stream", "geometry");
    expect(calls).toEqual([
      ["change", { background: "light" }],
      ["change", { background: "#ffffff" }],
      ["page.chooseStream", "geometry"],
    ]);
  });

  test("has a color of its own", () => {
    const { calls, choose } = stand(<ViewSection />, { ...scene, background: "#102030" });
    choose("Background color", "#ff0000");
    expect(calls).toEqual([["change", { background: "#ff0000" }]]);
  });

  test("tells why a stream was chosen", () => {
    const { root } = stand(<ViewSection />, scene, { streamWhy: "The line is slow." });
    expect(root.textContent).toContain("The line is slow.");
  });

  test("has an outline that is added once, then shown, hidden and colored", () => {
    const none = stand(<ViewSection />, scene);
    none.click("Outline");
    expect(none.calls).toEqual([["layers.add", "outline", { type: "outline" }]]);
    const shown = stand(<ViewSection />, { ...scene, layers: { box: { type: "outline" } } });
    shown.choose("Color of the outline", "#ff0000");
    shown.click("Outline");
    expect(shown.calls).toEqual([
      ["colors.set", { layers: ["box"] }, { solid: "#ff0000" }],
      ["layers.set", "box", { visible: false }],
    ]);
  });
});

test("annotations are switched, titled and sized", () => {
  const { calls, choose, click, slide } = stand(<ViewSection />, scene);
  for (const name of ["Legend", "Axes triad", "Axes of the box", "Dataset name", "Time"]) click(name);
  choose("Title", "Wing");
  slide("Text size", 120, 150);
  expect(calls).toEqual([
    ["change", { annotations: { legend: false } }, undefined],
    ["change", { annotations: { triad: false } }, undefined],
    ["change", { annotations: { axes: true } }, undefined],
    ["change", { annotations: { dataset: true } }, undefined],
    ["change", { annotations: { time: true } }, undefined],
    ["change", { annotations: { title: "Wing" } }, undefined],
    ["change", { annotations: { scale: 1.2 } }, "gesture-1"],
    ["change", { annotations: { scale: 1.5 } }, "gesture-1"],
  ]);
});

describe("the camera", () => {
  /** Applies a recorded change of the camera. */
  const changed = ([name, change]: Stand["calls"][number]): ViewCamera => {
    expect(name).toBe("camera.change");
    return (change as (camera: ViewCamera) => ViewCamera)(complete(scene.camera as ViewCamera));
  };

  test("takes a position, a target and an up direction", () => {
    const { calls, type } = stand(<CameraSection />, scene);
    type("Position x", "5");
    type("Target z", "1");
    type("Up x", "1");
    expect(calls).toEqual([
      ["camera.set", expect.objectContaining({ position: [5, -10, 0], target: [0, 0, 0], up: [0, 0, 1] })],
      ["camera.set", expect.objectContaining({ position: [0, -10, 0], target: [0, 0, 1] })],
      ["camera.set", expect.objectContaining({ up: [1, 0, 1] })],
    ]);
  });

  test("refuses places without a direction of sight", () => {
    const { calls, type } = stand(<CameraSection />, { ...scene, camera: { ...scene.camera, up: [0, 1, 1] } as never });
    type("Position y", "0");
    type("Up z", "0");
    expect(calls).toEqual([
      ["tell", expect.stringContaining("The camera's position equals its target"), "error"],
      ["tell", expect.stringContaining("The up vector is parallel to the view direction"), "error"],
    ]);
  });

  test("changes its projection, its angle and the height of the view", () => {
    const { calls, click, slide, type } = stand(<CameraSection />, scene);
    click("Parallel projection");
    slide("Field of view", 40, 60);
    type("Height of the view", "2");
    expect(calls.map(([, , gesture]) => gesture)).toEqual([undefined, "gesture-1", "gesture-1", undefined]);
    const [parallel, , wide, near] = calls.map(changed);
    expect(parallel?.parallel).toBe(true);
    expect(wide?.fov).toBe(60);
    expect(near?.position[1]).toBeCloseTo(-1 / Math.tan(Math.PI / 12), 6);
  });

  test("takes no height that is not above zero", () => {
    const { calls, type } = stand(<CameraSection />, scene);
    type("Height of the view", "-2");
    expect(calls).toEqual([]);
  });
});
