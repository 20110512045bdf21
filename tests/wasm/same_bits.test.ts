// Compares every array of another machine's results with the native build's, byte by byte; one test per mesh.
// CIEL_NATIVE and CIEL_FOUND: the two files of results.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

interface Item {
  name: string;
  bytes: Buffer;
}

function read(variable: string): Item[] {
  const path = process.env[variable];
  if (!path) throw new Error(`same_bits.test.ts: set ${variable} to a file of results`);
  const file = readFileSync(path);
  let at = 0;
  const next = (): Buffer => {
    const begin = at + 8;
    at = begin + Number(file.readBigUInt64LE(at));
    return file.subarray(begin, at);
  };
  const items: Item[] = [];
  while (at < file.length) items.push({ name: next().toString(), bytes: next() });
  return items;
}

const meshOf = (item: Item): string => item.name.slice(0, item.name.indexOf(" / "));

/** Returns null when both items are equal, otherwise a sentence about the first different byte. */
function difference(native: Item, found: Item | undefined): string | null {
  if (found?.name !== native.name) return `${native.name}: missing, there is ${found?.name ?? "nothing more"} instead`;
  if (native.bytes.equals(found.bytes)) return null;
  const offset = native.bytes.findIndex((byte, i) => found.bytes[i] !== byte);
  const sizes = `${native.bytes.length} bytes natively, ${found.bytes.length} here`;
  if (offset < 0) return `${native.name}: ${sizes}`;
  const hex = (bytes: Buffer): string => bytes.subarray(offset, offset + 8).toString("hex");
  return `${native.name}: differs from byte ${offset} on: ${hex(native.bytes)} natively, ${hex(found.bytes)} here (${sizes})`;
}

const native = read("CIEL_NATIVE");
const found = read("CIEL_FOUND");
const different = new Map<string, string[]>();
native.forEach((item, i) => {
  const mesh = different.get(meshOf(item)) ?? [];
  different.set(meshOf(item), mesh);
  const sentence = difference(item, found[i]);
  if (sentence !== null) mesh.push(sentence);
});

for (const [mesh, sentences] of different) {
  test(mesh, () => {
    assert.ok(sentences.length === 0, `${sentences.length} arrays differ, the first is ${sentences[0] ?? ""}`);
  });
}
test("nothing beyond", () => {
  assert.equal(found.length, native.length);
  assert.ok(different.size > 25, "fewer meshes than tests/support has");
});
