// Dataset of a row of four cubes, imported from a file.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { binary } from "./server.ts";

export const CELLS = 4;

/** Imports four cubes along x. Returns the dataset's path. Cell array q has the values; point array p equals x. */
export function rowIn(folder: string, values = ["0", "1", "2", "3"]): string {
  const points = [0, 1].flatMap((z) =>
    [0, 1].flatMap((y) => Array.from({ length: CELLS + 1 }, (_, x) => [x, y, z].join(" "))),
  );
  const row = CELLS + 1;
  const corners = (x: number): number[] => [x, x + 1, x + 1 + row, x + row].flatMap((at) => [at]);
  const cells = Array.from({ length: CELLS }, (_, x) =>
    ["8", ...corners(x), ...corners(x).map((at) => at + 2 * row)].join(" "),
  );
  const lines = [
    "# vtk DataFile Version 3.0",
    "row",
    "ASCII",
    "DATASET UNSTRUCTURED_GRID",
    `POINTS ${points.length} float`,
    ...points,
    `CELLS ${CELLS} ${9 * CELLS}`,
    ...cells,
    `CELL_TYPES ${CELLS}`,
    ...cells.map(() => "12"),
    `CELL_DATA ${CELLS}`,
    "SCALARS q float 1",
    "LOOKUP_TABLE default",
    ...values,
    `POINT_DATA ${points.length}`,
    "SCALARS p float 1",
    "LOOKUP_TABLE default",
    ...points.map((point) => point.split(" ")[0] ?? ""),
  ];
  const [input, output] = [join(folder, "row.vtk"), join(folder, "row.ciel")];
  writeFileSync(input, `${lines.join("\n")}\n`);
  const { status, stderr } = spawnSync(binary, ["import", input, "-o", output], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  return output;
}
