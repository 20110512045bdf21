import { describe, expect, test } from "vitest";
import { PatchesAtOnce } from "../src/server/patches_at_once";

const after = (...answers: number[]): number => {
  const patches = new PatchesAtOnce();
  for (const took of answers) patches.answered(took);
  return patches.count;
};

describe("changes on their way at once", () => {
  test.each([
    { name: "before an answer", answers: [], count: 2 },
    { name: "beside the server", answers: [3, 4], count: 2 },
    { name: "over a line of 200 ms", answers: [205, 210], count: 14 },
    { name: "over a line of seconds", answers: [5000], count: 32 },
    { name: "where a busy server keeps some waiting", answers: [8, 400, 900], count: 2 },
  ])("$name: $count", ({ answers, count }) => {
    expect(after(...answers)).toBe(count);
  });

  test("a line that has become longer is seen", () => {
    expect(after(3, ...Array.from({ length: 16 }, () => 200))).toBe(14);
  });
});
