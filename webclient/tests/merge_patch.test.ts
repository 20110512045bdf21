import { describe, expect, test } from "vitest";
import {
  applyPatch,
  composePatches,
  diff,
  equal,
  keepEqual,
  type Json,
  type JsonObject,
} from "../src/model/merge_patch";

// Document, patch and result of the examples in RFC 7396, appendix A.
const EXAMPLES: [Json, Json, Json][] = [
  [{ a: "b" }, { a: "c" }, { a: "c" }],
  [{ a: "b" }, { b: "c" }, { a: "b", b: "c" }],
  [{ a: "b" }, { a: null }, {}],
  [{ a: "b", b: "c" }, { a: null }, { b: "c" }],
  [{ a: ["b"] }, { a: "c" }, { a: "c" }],
  [{ a: "c" }, { a: ["b"] }, { a: ["b"] }],
  [{ a: { b: "c" } }, { a: { b: "d", c: null } }, { a: { b: "d" } }],
  [{ a: [{ b: "c" }] }, { a: [1] }, { a: [1] }],
  [
    ["a", "b"],
    ["c", "d"],
    ["c", "d"],
  ],
  [{ a: "b" }, ["c"], ["c"]],
  [{ a: "foo" }, null, null],
  [{ a: "foo" }, "bar", "bar"],
  [{ e: null }, { a: 1 }, { e: null, a: 1 }],
  [[1, 2], { a: "b", c: null }, { a: "b" }],
  [{}, { a: { bb: { ccc: null } } }, { a: { bb: {} } }],
];

// Returns a generator of random documents. Equal seeds give equal documents.
function documents(seed: number): () => JsonObject {
  let state = seed;
  const random = (): number => {
    state = (state * 1664525 + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const value = (depth: number): Json => {
    const kind = Math.floor(random() * (depth > 0 ? 5 : 3));
    if (kind === 0) return Math.floor(random() * 4);
    if (kind === 1) return random() < 0.5;
    if (kind === 2) return [Math.floor(random() * 3), "x"];
    return object(depth - 1);
  };
  const object = (depth: number): JsonObject => {
    const result: JsonObject = {};
    for (const key of "abcd") if (random() < 0.6) result[key] = value(depth);
    return result;
  };
  return () => object(3);
}

describe("merge patch", () => {
  test.each(EXAMPLES)("RFC 7396: %j patched by %j is %j", (document, patch, result) => {
    expect(applyPatch(document, patch)).toEqual(result);
  });

  test("a patch leaves its arguments alone", () => {
    const document = { a: { b: 1 } };
    applyPatch(document, { a: { b: 2 } });
    expect(document).toEqual({ a: { b: 1 } });
  });

  test("the difference leads from one document to the other and back", () => {
    const next = documents(7);
    for (let i = 0; i < 300; i += 1) {
      const [from, to] = [next(), next()];
      expect(applyPatch(from, diff(from, to))).toEqual(to);
      expect(applyPatch(to, diff(to, from))).toEqual(from);
      expect(diff(from, from)).toEqual({});
    }
  });

  test("a composed patch does what the two do", () => {
    const next = documents(11);
    let impossible = 0;
    for (let i = 0; i < 300; i += 1) {
      const [document, second, third] = [next(), next(), next()];
      const first = diff(document, second);
      const then = diff(second, third);
      const both = composePatches(first, then);
      if (both === null) impossible += 1;
      else expect(applyPatch(document, both)).toEqual(third);
    }
    expect(impossible).toBeGreaterThan(0);
    expect(impossible).toBeLessThan(200);
  });

  test("what no patch can do is not composed", () => {
    expect(composePatches({ a: null }, { a: { b: 1 } })).toBeNull();
    expect(composePatches({ a: [1] }, { a: { b: 1 } })).toBeNull();
    expect(composePatches({ a: { b: null } }, { a: { b: { c: 1 } } })).toBeNull();
    expect(composePatches({ a: { b: 1 } }, { a: null })).toEqual({ a: null });
  });

  test("equality looks inside", () => {
    expect(equal({ a: [1, { b: 2 }] }, { a: [1, { b: 2 }] })).toBe(true);
    expect(equal({ a: undefined as unknown as Json }, { b: 1 })).toBe(false);
    expect(equal([1, 2], [1])).toBe(false);
    expect(equal({ a: 1 }, [1])).toBe(false);
  });
});

describe("keeping equal parts", () => {
  const before = { a: { x: [1, 2] }, b: { y: [{ z: 1 }, { z: 2 }] }, c: 3 };

  test("an equal document is the one of before", () => {
    expect(keepEqual(before, structuredClone(before))).toBe(before);
    expect(keepEqual(before, { c: 3, b: structuredClone(before.b), a: structuredClone(before.a) })).toBe(before);
  });

  test("a document that differs keeps the parts that do not", () => {
    const after = { ...structuredClone(before), c: 4, d: null };
    const kept = keepEqual(before, after) as JsonObject;
    expect(kept).toEqual(after);
    expect(kept.a).toBe(before.a);
    expect(kept.b).toBe(before.b);
  });

  test("a list that differs keeps its equal items", () => {
    const kept = keepEqual(before, { ...before, b: { y: [{ z: 1 }, { z: 5 }, { z: 6 }] } }) as typeof before;
    expect(kept.b.y).toEqual([{ z: 1 }, { z: 5 }, { z: 6 }]);
    expect(kept.b.y[0]).toBe(before.b.y[0]);
    expect(keepEqual(before, { ...before, b: { y: [{ z: 1 }] } })).toEqual({ ...before, b: { y: [{ z: 1 }] } });
  });

  test("a part that is gone is not kept", () => {
    expect(keepEqual(before, { c: 3 })).toEqual({ c: 3 });
    expect(keepEqual(before, { a: [1], b: 2, c: 3 })).toEqual({ a: [1], b: 2, c: 3 });
    expect(keepEqual(undefined, before)).toBe(before);
  });
});
