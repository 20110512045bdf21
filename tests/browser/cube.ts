// Dataset of one cell. The array x rises from 0 to 1 along the x axis; the array c is constant.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { binary } from "./server.ts";

const VTK = `# vtk DataFile Version 3.0
cube
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 float
0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1
CELLS 1 9
8 0 1 2 3 4 5 6 7
CELL_TYPES 1
12
POINT_DATA 8
SCALARS x float 1
LOOKUP_TABLE default
0 1 1 0 0 1 1 0
SCALARS c float 1
LOOKUP_TABLE default
3 3 3 3 3 3 3 3
`;

/** Imports the cube and returns the path of the dataset. */
export function cubeIn(folder: string): string {
  const [input, output] = [join(folder, "cube.vtk"), join(folder, "cube.ciel")];
  writeFileSync(input, VTK);
  const { status, stderr } = spawnSync(binary, ["import", input, "-o", output], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  return output;
}
