import { expect, test } from "vitest";
import type { Range } from "../src/generated/protocol";
import { percentiles, type Counts } from "../src/model/percentiles";

/** Counts values like the server's histogram: per bin, and below and above the range. */
const counter =
  (values: readonly number[], bins = 100) =>
  (range: Range | null): Promise<Counts> => {
    const [low, high] = range ?? [Math.min(...values), Math.max(...values)];
    const counts = Array.from({ length: bins }, () => 0);
    let [below, above] = [0, 0];
    for (const value of values) {
      const bin = high > low ? Math.min(bins - 1, Math.floor(((value - low) / (high - low)) * bins)) : 0;
      if (value < low) below += 1;
      else if (value > high) above += 1;
      else counts[bin] = (counts[bin] ?? 0) + 1;
    }
    return Promise.resolve({ range: [low, high], counts, below, above });
  };

const bulk = Array.from({ length: 10_000 }, (_, i) => i / 10_000);

test("evenly spread values lose a hundredth at each end", async () => {
  const [low, high] = (await percentiles(counter(bulk), [0.01, 0.99])) ?? [NaN, NaN];
  expect(low).toBeCloseTo(0.01, 1);
  expect(high).toBeCloseTo(0.99, 1);
});

test("single values far away do not stretch the range, however far", async () => {
  for (const far of [1e3, 1e9]) {
    const [low, high] = (await percentiles(counter([...bulk, -far, far]), [0.01, 0.99])) ?? [NaN, NaN];
    expect(low).toBeCloseTo(0.01, 1);
    expect(high).toBeCloseTo(0.99, 1);
  }
});

test("one value has its own range, no value none", async () => {
  expect(await percentiles(counter([3, 3, 3]), [0.01, 0.99])).toEqual([3, 3]);
  expect(
    await percentiles(() => Promise.resolve({ range: [0, 1], counts: [0], below: 0, above: 0 }), [0.01, 0.99]),
  ).toBeNull();
});
