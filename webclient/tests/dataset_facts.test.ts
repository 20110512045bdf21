import { expect, test } from "vitest";
import type { DatasetDescription } from "../src/generated/protocol";
import { datasetFacts } from "../src/model/dataset_facts";

test("cells, steps, arrays and size, with the right plurals", () => {
  const mesh = { cells: { hexahedra: 350_000, polyhedra: 3 } };
  const description = { mesh, times: [500], arrays: [{}, {}], bounds: [-5, 15, -4, 4, 0, 8], length_units: "m" };
  expect(datasetFacts(description as unknown as DatasetDescription)).toEqual([
    "350\u202f003 cells",
    "1 time step",
    "2 arrays",
    "20\u00a0\u00d7\u00a08\u00a0\u00d7\u00a08\u00a0m",
  ]);
});

test("steps that have not been read are counted", () => {
  const description = {
    mesh: { cells: {} },
    times: [0, 1, 2],
    unread_steps: 1,
    arrays: [],
    bounds: [0, 1, 0, 1, 0, 1],
  };
  const facts = datasetFacts({ ...description, length_units: "" } as unknown as DatasetDescription);
  expect(facts[1]).toBe("3 time steps (1 not read yet)");
});
