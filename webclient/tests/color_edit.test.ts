import { describe, expect, test } from "vitest";
import { colorOf, hexOf, scaleOf } from "../src/model/color_scale";
import type { ColorPoint } from "../src/generated/protocol";
import {
  addedPoint,
  movedPoint,
  pointsOf,
  withLog,
  withMap,
  withDataRange,
  withRange,
  withRangeEnd,
  withSymmetric,
  type ColoringChange,
} from "../src/model/color_edit";

describe("a hand on the coloring", () => {
  test.each<[string, ColoringChange | string, ColoringChange | string]>([
    ["log takes symmetric away", withLog({ symmetric: true }, true), { log: true, symmetric: undefined }],
    ["log keeps a range above zero", withLog({ range: [1, 2] }, true), { log: true, symmetric: undefined }],
    [
      "log keeps of a range what lies above zero",
      withLog({ range: [-1, 1000] }, true),
      { log: true, symmetric: undefined, range: [0.001, 1000] },
    ],
    [
      "log lets a range below zero go",
      withLog({ range: [-3, 0] }, true),
      { log: true, symmetric: undefined, range: undefined },
    ],
    ["log ends", withLog({ log: true }, false), { log: undefined }],
    [
      "log that ends gives back what it took",
      withLog({ array: "p", log: true, range: [1e-6, 1] }, false, { array: "p", symmetric: true, range: [-1, 1] }),
      { log: undefined, symmetric: true, range: [-1, 1] },
    ],
    [
      "log that ends gives back the range that it let go",
      withLog({ array: "p", log: true }, false, { array: "p", range: [-3, 0] }),
      { log: undefined, symmetric: undefined, range: [-3, 0] },
    ],
    [
      "log that ends keeps a range that was typed meanwhile",
      withLog({ array: "p", log: true, range: [2, 3] }, false, { array: "p", range: [-1, 1] }),
      { log: undefined, symmetric: undefined },
    ],
    [
      "log that ends gives an array nothing of another",
      withLog({ array: "q", log: true }, false, { array: "p", symmetric: true }),
      { log: undefined },
    ],
    ["symmetric takes log away", withSymmetric(true), { symmetric: true, log: undefined }],
    ["a range in any order", withRange({}, 3, -1), { range: [-1, 3] }],
    ["a symmetric range", withRange({ symmetric: true }, -1, 3), { range: [-3, 3] }],
    ["values on a logarithmic scale", withDataRange({ log: true }, [0, 2000]), { range: [0.002, 2000] }],
    ["values on one of both signs", withDataRange({ log: true, symmetric: true }, [-1, 3]), { range: [-3, 3] }],
    ["values on a linear scale", withDataRange({}, [-1, 3]), { range: [-1, 3] }],
    ["an end typed", withRangeEnd({}, [0, 4], 0, 1), { range: [1, 4] }],
    ["a lower end that pushes the upper", withRangeEnd({}, [0.19, 4.98], 0, 5), { range: [5, 5] }],
    ["then the upper", withRangeEnd({}, [5, 5], 1, 10), { range: [5, 10] }],
    ["an upper end that pushes the lower", withRangeEnd({}, [0, 4], 1, -2), { range: [-2, -2] }],
    ["an end of a symmetric range", withRangeEnd({ symmetric: true }, [-4, 4], 0, -2), { range: [-2, 2] }],
    [
      "no logarithmic end at zero",
      withRangeEnd({ log: true }, [1, 4], 1, 0),
      "A logarithmic scale begins above zero; type a value above zero",
    ],
    [
      "no logarithmic range from zero",
      withRange({ log: true }, 0, 3),
      "A logarithmic scale begins above zero; type a value above zero",
    ],
    ["a map goes before points", withMap("vik"), { map: "vik", points: undefined }],
  ])("%s", (_, change, expected) => expect(change).toStrictEqual(expected));
});

describe("points", () => {
  const points: ColorPoint[] = [
    { at: 0, color: "#000000" },
    { at: 0.2, color: "#ff0000" },
    { at: 1, color: "#ffffff" },
  ];

  test("begin as what is seen, reversed or not", () => {
    for (const reverse of [false, true]) {
      const scale = scaleOf({ map: "vik", reverse }, [0, 4]);
      const own = scaleOf({ points: pointsOf(scale), reverse }, [0, 4]);
      for (const value of [0, 1, 2, 3, 4]) expect(colorOf(own, value)).toEqual(colorOf(scale, value));
    }
  });

  test("stay between their neighbours", () => {
    expect(movedPoint(points, 1, 0.7)[1]?.at).toBe(0.7);
    expect(movedPoint(points, 1, 7)[1]?.at).toBe(1);
    expect(movedPoint(points, 0, 0.5)[0]?.at).toBe(0.2);
    expect(movedPoint(points, 2, -1)[2]?.at).toBe(0.2);
  });

  test("one more goes into the widest gap and changes nothing", () => {
    const scale = scaleOf({ points }, [0, 1]);
    const more = addedPoint(points, (place) => hexOf(colorOf(scale, place)));
    expect(more.map(({ at }) => at)).toEqual([0, 0.2, 0.6, 1]);
    expect(colorOf(scaleOf({ points: more }, [0, 1]), 0.4)).toEqual(colorOf(scale, 0.4));
  });
});
