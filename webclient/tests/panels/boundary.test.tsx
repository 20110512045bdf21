// @vitest-environment happy-dom
import { describe, expect, test } from "vitest";
import type { EdgesLayer, PointsLayer, Scene, SurfaceLayer } from "../../src/generated/protocol";
import { BoundarySection } from "../../src/panels/layers/boundary_section";
import { LinesAndPointsSection } from "../../src/panels/layers/lines_and_points_section";
import { stand, described, type Stand } from "./stand";

const boundary = (layers: Record<string, SurfaceLayer>): Stand =>
  stand(<BoundarySection />, { dataset: "box", layers } satisfies Scene);

describe("the boundary", () => {
  test("is shown by its first patch that is ticked, and hidden with its last", () => {
    const none = boundary({});
    none.click("inlet");
    expect(none.calls).toEqual([["layers.add", "surface", { type: "surface", groups: ["inlet"] }]]);
    const one = boundary({ wall: { type: "surface", groups: ["inlet"] } });
    one.click("inlet");
    expect(one.calls).toEqual([["layers.set", "wall", { visible: false }]]);
  });

  test("gets another layer of a patch that no layer shows", () => {
    const { calls, click } = boundary({ wall: { type: "surface", groups: ["wall_left"] } });
    click("Add another layer of the boundary");
    expect(calls).toEqual([
      ["layers.add", "surface", { type: "surface", groups: ["wall_right"], color: { solid: "#e69f00" } }],
    ]);
  });

  test("gets no layer while its dataset is opening, because its patches are not known", () => {
    const { calls, change, click, find, model } = boundary({ wall: { type: "surface" } });
    const add = (): HTMLButtonElement => find("Add another layer of the boundary") as HTMLButtonElement;
    change(() => void (model.description.value = null));
    expect(add().disabled).toBe(true);
    click("Add another layer of the boundary");
    expect(calls).toEqual([]);
    change(() => void (model.description.value = described));
    expect(add().disabled).toBe(false);
  });

  test("has further layers that are hidden and removed", () => {
    const { calls, click } = boundary({ wall: { type: "surface" }, wall2: { type: "surface", groups: ["inlet"] } });
    click("Hide boundary 2");
    click("Remove boundary 2");
    expect(calls).toEqual([
      ["layers.set", "wall2", { visible: false }],
      ["layers.remove", "wall2"],
    ]);
  });

  test("has cell edges of a color and a width", () => {
    const { calls, click, choose, type } = boundary({ wall: { type: "surface", edges: { width: 2 } } });
    choose("Color of the edges", "#ff0000");
    type("Width of the edges in pixels", "3");
    click("Cell edges");
    expect(calls).toEqual([
      ["layers.set", "wall", { edges: { color: "#ff0000" } }],
      ["layers.set", "wall", { edges: { width: 3 } }],
      ["layers.set", "wall", { edges: { visible: false } }],
    ]);
  });
});

describe("the list of patches", () => {
  const groups = (calls: Stand["calls"]): unknown[] => calls.map(([, , change]) => change);

  test("shows the whole boundary, all, none, the others or only one patch", () => {
    const { calls, click } = boundary({ wall: { type: "surface", groups: ["inlet"] } });
    for (const button of ["Whole boundary", "All", "None", "Invert", "Only inlet"]) click(button);
    expect(groups(calls)).toEqual([
      { visible: true, groups: [] },
      { visible: true, groups: [] },
      { visible: false },
      { visible: true, groups: ["wall_left", "wall_right"] },
      { visible: true, groups: ["inlet"] },
    ]);
  });

  test("has families that unfold, and are ticked together", () => {
    const { calls, click, find } = boundary({ wall: { type: "surface", groups: ["wall_left"] } });
    expect((find("All of wall") as HTMLInputElement).indeterminate).toBe(true);
    click("All of wall");
    click("Only all of wall");
    click("Patches of wall");
    click("wall_left");
    expect(groups(calls)).toEqual([
      { visible: true, groups: ["wall_left", "wall_right"] },
      { visible: true, groups: ["wall_left", "wall_right"] },
      { visible: false },
    ]);
  });

  test("of many patches is searched, and its buttons act on what is found", () => {
    const many = Array.from({ length: 9 }, (_, i) => ({ name: `face${i}`, of: "faces" as const, count: 1 }));
    const { calls, change, click, model, root, type } = boundary({ wall: { type: "surface", groups: ["face1"] } });
    change(() => void (model.description.value = { ...described, groups: many }));
    type("Search patches", "face3");
    expect(root.querySelectorAll(".patch-list li").length).toBe(1);
    click("All");
    expect(groups(calls)).toEqual([{ visible: true, groups: ["face1", "face3"] }]);
  });
});

describe("thresholds", () => {
  const threshold = { array: "p", range: [2, 8] as [number, number] };

  test("begin with the upper half of the data, also for another array", () => {
    const off = boundary({ wall: { type: "surface", color: { array: "p" } } });
    off.click("Threshold");
    expect(off.calls).toEqual([
      ["layers.set", "wall", { threshold: { enabled: true, array: "p", range: [5, 10] } }, undefined],
    ]);
    const on = boundary({ wall: { type: "surface", threshold } });
    on.choose("Cells by", "T");
    expect(on.calls).toEqual([
      ["layers.set", "wall", { threshold: { enabled: true, array: "T", range: [300, 400] } }, undefined],
    ]);
  });

  test("have ends that slide and are typed, vertices to count, and a switch", () => {
    const { calls, choose, click, slide, type } = boundary({ wall: { type: "surface", threshold } });
    slide("Lower end of the threshold", 0.3, 0.4);
    type("Threshold to", "1");
    choose("Of their vertices", "any");
    click("Threshold");
    expect(calls).toEqual([
      ["layers.set", "wall", { threshold: { range: [3, 8] } }, "gesture-1"],
      ["layers.set", "wall", { threshold: { range: [4, 8] } }, "gesture-1"],
      ["layers.set", "wall", { threshold: { range: [1, 1] } }, undefined],
      ["layers.set", "wall", { threshold: { keep: "any" } }, undefined],
      ["layers.set", "wall", { threshold: { enabled: false } }, undefined],
    ]);
  });
});

describe("lines and points", () => {
  const section = (layers: Record<string, EdgesLayer | PointsLayer>): Stand =>
    stand(<LinesAndPointsSection />, { dataset: "box", layers });

  test("are added by their buttons", () => {
    const { calls, click } = section({});
    click("Add edges of the mesh");
    click("Add points of the mesh");
    expect(calls).toEqual([
      ["layers.add", "edges", { type: "edges", angle: 30 }],
      ["layers.add", "points", { type: "points" }],
    ]);
  });

  test("of edges have an angle and a width", () => {
    const { calls, choose, click, type } = section({ bends: { type: "edges", angle: 30 } });
    type("Angle in degrees", "45");
    type("Width of the lines in pixels", "2");
    choose("Which", "all");
    click("Hide these edges");
    click("Remove these edges");
    expect(calls).toEqual([
      ["layers.set", "bends", { angle: 45 }],
      ["layers.set", "bends", { width: 2 }],
      ["layers.set", "bends", { angle: null }],
      ["layers.set", "bends", { visible: false }],
      ["layers.remove", "bends"],
    ]);
  });

  test("of points have a size and a number, and patches unless all are shown", () => {
    const { calls, choose, click, key, root, type } = section({ dots: { type: "points" } });
    choose("Which", "all");
    key("Size of the points in pixels", "ArrowUp");
    type("Number of points at most", "1000.4");
    click("inlet");
    expect(calls).toEqual([
      ["layers.set", "dots", { of: "all", groups: null }],
      ["layers.set", "dots", { size: 5 }],
      ["layers.set", "dots", { most: 1000 }],
      ["layers.set", "dots", { groups: ["inlet"] }],
    ]);
    expect(root.querySelector(".patches")).not.toBeNull();
    expect(section({ dots: { type: "points", of: "all" } }).root.querySelector(".patches")).toBeNull();
  });
});
