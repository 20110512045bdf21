import { expect, test } from "vitest";
import { probeText } from "../src/model/probe_text";

test("a line each with all digits; what is not written is empty", () => {
  const result = {
    hit: true,
    position: [1, 2.000000001, -3] as [number, number, number],
    cell: 7,
    vertex: null,
    layer: "surface",
    patch: "wall",
    values: { p: 101325.123456789, late: null },
    solver_cell: 4711,
  };
  const context = {
    dataset: "box",
    time: 0.5,
    lengthUnits: "m",
    unitsOf: (name: string) => (name === "p" ? "Pa" : ""),
  };
  expect(probeText(result, context).split("\n")).toEqual([
    "dataset\tbox",
    "time\t0.5",
    "x\t1\tm",
    "y\t2.000000001\tm",
    "z\t-3\tm",
    "patch\twall",
    "cell\t7",
    "solver's cell\t4711",
    "p\t101325.123456789\tPa",
    "late",
  ]);
});
