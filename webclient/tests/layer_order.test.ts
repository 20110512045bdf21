import { describe, expect, test } from "vitest";
import type { Layer, Scene } from "../src/generated/protocol";
import { applyPatch, type Json } from "../src/model/merge_patch";
import { layersInOrder, movedTo } from "../src/model/layer_order";

const outline = (order?: number): Layer => ({ type: "outline", ...(order !== undefined && { order }) });
const scene: Scene = { dataset: "d", layers: { c: outline(), b: outline(), a: outline(7), d: outline(-1) } };
const ids = (of: Scene): string[] => layersInOrder(of).map(([id]) => id);
const after = (of: Scene, id: string, place: number): Scene =>
  applyPatch(of as unknown as Json, { layers: movedTo(of, id, place) ?? {} }) as unknown as Scene;

describe("the order of layers", () => {
  test("is by order, then by id, as the server draws them", () => {
    expect(ids(scene)).toEqual(["d", "b", "c", "a"]);
    expect(layersInOrder(null)).toEqual([]);
  });

  test("any layer comes to any place, and the others stay as they were", () => {
    for (const id of ids(scene))
      for (let place = 0; place < 4; place += 1) {
        const moved = ids(after(scene, id, place));
        expect(moved[place]).toBe(id);
        expect(moved.filter((other) => other !== id)).toEqual(ids(scene).filter((other) => other !== id));
      }
  });

  test("where nothing moves, nothing is said; beyond the end is the end", () => {
    expect(movedTo(scene, "b", 1)).toBeNull();
    expect(movedTo(scene, "gone", 0)).toBeNull();
    expect(movedTo(scene, "a", 99)).toBeNull();
    expect(ids(after(scene, "d", 99))).toEqual(["b", "c", "a", "d"]);
  });

  test("only what changes is in the patch, and nothing but the order", () => {
    const tidy: Scene = { dataset: "d", layers: { a: outline(0), b: outline(1), c: outline(2) } };
    expect(movedTo(tidy, "b", 0)).toEqual({ b: { order: 0 }, a: { order: 1 } });
  });
});
