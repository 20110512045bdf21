import { describe, expect, test } from "vitest";
import { applyPatch } from "../src/model/merge_patch";
import { evenValues, mapBeside, ofArray } from "../src/model/contours";

describe("contour lines", () => {
  test("values to begin with are those that even ones had", () => {
    expect(evenValues({ array: "p", count: 3 }, [0, 1])).toEqual([0.25, 0.5, 0.75]);
    expect(evenValues({ array: "p", count: 1, range: [2, 3] }, [0, 1])).toEqual([2.5]);
    expect(evenValues({ array: "p" }, [0, 11])).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  });

  test("lines begin with another map than the slice below them", () => {
    expect(
      [undefined, {}, { array: "p" }, { array: "p", map: "viridis" }, { array: "p", map: "vik" }].map(mapBeside),
    ).toEqual(["viridis", "viridis", "inferno", "inferno", "viridis"]);
  });

  test("another array has other values, and what colors the lines follows it", () => {
    const lines = { array: "p", values: [1], coloring: { array: "p", map: "vik", range: [0, 1] as [number, number] } };
    expect(applyPatch(lines, ofArray(lines, "q") as never)).toEqual({ array: "q", coloring: { map: "vik" } });
    expect(applyPatch({ array: "p", count: 3 }, ofArray({ array: "p" }, "q") as never)).toEqual({
      array: "q",
      count: 3,
    });
  });
});
