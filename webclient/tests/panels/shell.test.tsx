// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { PictureMenu } from "../../src/panels/shell/picture_menu";
import { ShareMenu } from "../../src/panels/shell/share_menu";
import { StatusBar } from "../../src/panels/shell/status_bar";
import { Toolbar } from "../../src/panels/shell/toolbar";
import { emptyReadout } from "../../src/model/state";
import { stand } from "./stand";

const scene: Scene = { dataset: "box", layers: { iso: { type: "iso", array: "p", values: [2] } } };
const datasets = [
  { name: "box", problem: "" },
  { name: "ball", problem: "" },
] as never;

describe("the toolbar", () => {
  test("opens a dataset and looks along an axis", () => {
    const { calls, choose, click } = stand(<Toolbar />, scene, { datasets });
    choose("Dataset", "ball");
    click("Show what is drawn");
    click("Look from minus y");
    expect(calls).toEqual([["openDataset", "ball"], ["camera.reset"], ["camera.lookFrom", "-y"]]);
  });

  test("saves a picture, exports a surface, and changes the theme", () => {
    const { calls, click } = stand(<Toolbar />, scene, { datasets, theme: "light" });
    click("Save a picture");
    click("Export a surface");
    click("Triangles only");
    click("STL");
    click("Theme: light");
    click("Side panel");
    expect(calls).toEqual([
      ["files.screenshot"],
      ["files.exportSurface", "iso", "stl", true],
      ["page.setTheme", "dark"],
      ["page.togglePanel"],
    ]);
  });
});

describe("the menu of pictures", () => {
  test("saves the size of the view, a typed size or a usual one, and closes", () => {
    const { calls, click, root, type } = stand(<PictureMenu disabled={false} />, scene);
    const save = (choose: () => void): void => {
      click("Pictures of other sizes");
      choose();
      click("Save");
      expect(root.querySelector(".menu-body")).toBeNull();
    };
    save(() => undefined);
    save(() => type("Width of the picture in pixels", "1000"));
    save(() => click("4K"));
    save(() => click("1 times as large as the view"));
    expect(calls).toEqual(
      [
        [800, 600],
        [1000, 600],
        [3840, 2160],
        [800, 600],
      ].map(([width, height]) => ["files.screenshot", { width, height }]),
    );
  });

  test("tells the limits of a size", () => {
    const { calls, click, type } = stand(<PictureMenu disabled={false} />, scene);
    click("Pictures of other sizes");
    type("Height of the picture in pixels", "3");
    expect(calls).toEqual([["tell", expect.stringContaining("from 16 to 8192")]]);
  });

  test("closes by Escape and by a press beside it", () => {
    const { change, click, key, root } = stand(<PictureMenu disabled={false} />, scene);
    click("Pictures of other sizes");
    key("Save", "Escape");
    expect(root.querySelector(".menu-body")).toBeNull();
    click("Pictures of other sizes");
    change(() => void document.body.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true })));
    expect(root.querySelector(".menu-body")).toBeNull();
  });
});

test("links are copied, and the menu closes", () => {
  const { calls, click, root } = stand(<ShareMenu disabled={false} />, scene);
  click("Share");
  click("Copy a link to this view");
  expect(root.querySelector(".menu-body")).toBeNull();
  click("Share");
  click("Copy a link to this session");
  expect(calls).toEqual([["files.copyLink"], ["files.copySessionLink"]]);
});

test("the status bar tells the picture that is shown", () => {
  const readout = {
    ...emptyReadout,
    stream: "image" as const,
    still: true,
    framesPerSecond: 12,
    latencyMs: 8,
    triangles: 3,
  };
  const { change, model, root } = stand(<StatusBar />, scene, { readout, shownScene: scene });
  for (const words of ["1 cells", "image, still", "3 triangles", "latency 8.0 ms", "12 fps"])
    expect(root.textContent).toContain(words);
  change(() => void (model.readout.value = { ...readout, stream: "geometry" }));
  expect(root.querySelector("[data-readout=stream]")?.textContent).toBe("geometry");
});
