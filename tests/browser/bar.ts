// Dataset of a row of cells, written as an OpenFOAM case. Its patches are "inlet", "outlet", and one for each other
// side of each cell, such as "bar_0-bottom". p is 0 at the inlet and rises by 1 per cell.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { binary } from "./server.ts";

const SIDES = ["bottom", "top", "front", "back"] as const;

interface Face {
  corners: number[];
  owner: number;
  patch: string;
}

/** Index of a point in the section at x = i. of: 0 to 3, counter-clockwise about x at (y, z) from (0, 0) to (0, 1). */
const corner = (i: number, of: number): number => 4 * i + of;

function sideOf(cell: number, side: (typeof SIDES)[number]): number[] {
  const [a, b] = { bottom: [0, 1], top: [2, 3], front: [3, 0], back: [1, 2] }[side] as [number, number];
  return [corner(cell, b), corner(cell + 1, b), corner(cell + 1, a), corner(cell, a)];
}

function facesOf(cells: number): { inner: Face[]; outer: Face[] } {
  const section = (i: number): number[] => [0, 1, 2, 3].map((of) => corner(i, of));
  const inner = Array.from({ length: cells - 1 }, (_, i) => ({ corners: section(i + 1), owner: i, patch: "" }));
  const ends: Face[] = [
    { corners: section(0).reverse(), owner: 0, patch: "inlet" },
    { corners: section(cells), owner: cells - 1, patch: "outlet" },
  ];
  const sides = Array.from({ length: cells }, (_, cell) =>
    SIDES.map((side) => ({ corners: sideOf(cell, side), owner: cell, patch: `bar_${cell}-${side}` })),
  );
  return { inner, outer: [...ends, ...sides.flat()] };
}

function header(kind: string, object: string): string {
  return `FoamFile { version 2.0; format ascii; class ${kind}; object ${object}; }\n`;
}

const listOf = (items: readonly string[]): string => `${items.length}\n(\n${items.join("\n")}\n)\n`;

/** Imports a bar and returns the path of the dataset. It has 2 + 4 * cells patches. */
export function barIn(folder: string, cells = 8): string {
  const [source, output] = [join(folder, "bar"), join(folder, "bar.ciel")];
  const mesh = join(source, "constant/polyMesh");
  for (const path of [mesh, join(source, "system"), join(source, "1")]) mkdirSync(path, { recursive: true });
  const { inner, outer } = facesOf(cells);
  const faces = [...inner, ...outer];
  const points = Array.from({ length: cells + 1 }, (_, x) =>
    ["0 0", "1 0", "1 1", "0 1"].map((yz) => `(${x} ${yz})`),
  ).flat();
  const patches = outer.map(({ patch }, i) => `"${patch}" { type patch; nFaces 1; startFace ${inner.length + i}; }`);
  const write = (path: string, kind: string, object: string, text: string): void =>
    writeFileSync(join(path, object), header(kind, object) + text);
  write(mesh, "vectorField", "points", listOf(points));
  write(mesh, "faceList", "faces", listOf(faces.map(({ corners }) => `4(${corners.join(" ")})`)));
  write(mesh, "labelList", "owner", listOf(faces.map(({ owner }) => String(owner))));
  write(mesh, "labelList", "neighbour", listOf(inner.map(({ owner }) => String(owner + 1))));
  write(mesh, "polyBoundaryMesh", "boundary", listOf(patches));
  write(
    join(source, "system"),
    "dictionary",
    "controlDict",
    "startTime 0; endTime 1; deltaT 1; writeControl timeStep;\n",
  );
  const values = Array.from({ length: cells }, (_, cell) => String(cell));
  const field = `internalField nonuniform List<scalar> ${listOf(values)};\nboundaryField { ".*" { type zeroGradient; } }\n`;
  write(join(source, "1"), "volScalarField", "p", `dimensions [0 2 -2 0 0 0 0];\n${field}`);
  const { status, stderr } = spawnSync(binary, ["import", source, "-o", output], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  return output;
}
