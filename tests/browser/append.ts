// Appends one more time step to a served dataset by `ciel append`, as a running simulation does.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { binary, nameOf } from "./server.ts";

interface Description {
  times: number[];
  input: { vertices: number };
  arrays: { name: string; association: "point" | "cell"; components: number; range: [number, number] | null }[];
}

async function describeDataset(address: string, dataset: string): Promise<Description> {
  const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "dataset.describe", params: { dataset } });
  const headers = { "Content-Type": "application/json" };
  const response = await fetch(new URL("rpc", address), { method: "POST", headers, body });
  return ((await response.json()) as { result: Description }).result;
}

/** Encodes an array as a file in NumPy's .npy format, version 1.0. */
function npy(rows: number, columns: number, value: (row: number) => number): Buffer {
  const shape = columns === 1 ? `(${rows},)` : `(${rows}, ${columns})`;
  const text = `{'descr': '<f4', 'fortran_order': False, 'shape': ${shape}, }`;
  const header = text.padEnd(Math.ceil((text.length + 11) / 64) * 64 - 11, " ") + "\n";
  const start = Buffer.from("\x93NUMPY\x01\x00\x00\x00", "latin1");
  start.writeUInt16LE(header.length, 8);
  const values = Float32Array.from({ length: rows * columns }, (_, i) => value(Math.floor(i / columns)));
  return Buffer.concat([start, Buffer.from(header, "latin1"), Buffer.from(values.buffer)]);
}

/** Appends a time step with all point arrays. Each rises from its lowest to its highest value, by index of point. */
export async function appendStep(address: string, path: string, folder: string): Promise<void> {
  const { times, input, arrays } = await describeDataset(address, nameOf(path));
  const options = arrays.flatMap(({ name, association, components, range }) => {
    if (association !== "point" || range === null) return [];
    const file = join(folder, `${name}.npy`);
    const [low, high] = range;
    writeFileSync(
      file,
      npy(input.vertices, components, (row) => low + ((high - low) * row) / input.vertices),
    );
    return ["--array", `${name}=${file}`];
  });
  const { status, stderr } = spawnSync(
    binary,
    ["append", path, "--time", String((times.at(-1) ?? 0) + 1), ...options],
    {
      encoding: "utf8",
    },
  );
  assert.equal(status, 0, stderr);
}
