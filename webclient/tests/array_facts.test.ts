import { expect, test } from "vitest";
import type { ArrayInfo } from "../src/generated/protocol";
import { arrayFacts } from "../src/model/array_facts";
import { cellsText, extremesText } from "../src/model/cell_extremes";

const array: ArrayInfo = {
  name: "p",
  association: "point",
  components: 1,
  units: "",
  description: "",
  range: null,
  scalars: ["p"],
  times: [0, 1],
  origin: "interpolated",
  stored: "float64",
  invalid: 0,
  missing: 0,
};

test("where an array comes from, and what is wrong with it", () => {
  expect(arrayFacts({ ...array, type: "float64", file: "0/p" }, 2)).toEqual([
    "on points",
    "interpolated from cells float64",
    "0/p",
  ]);
  expect(arrayFacts({ ...array, type: "int32" }, 2)).toContain("stored as float64");
  const bad: ArrayInfo = { ...array, association: "boundary_face", origin: "original", invalid: 12 };
  expect(arrayFacts(bad, 5)).toEqual([
    "on patches",
    "original",
    "missing at 3 of 5 times",
    "12 values are not numbers",
  ]);
});

test("the extremes of cells, short and whole", () => {
  const lowest = { value: -0.1, cell: 17, place: [0, 1, 2] as [number, number, number], time: 0 };
  const highest = { ...lowest, value: 63.6, cell: 5 };
  expect(cellsText({ lowest, highest })).toBe("cells: \u22120.1 to 63.6");
  expect(extremesText({ lowest, highest })).toBe(
    "Lowest \u22120.1 in cell 17 at (0, 1, 2); highest 63.6 in cell 5 at (0, 1, 2)",
  );
});
