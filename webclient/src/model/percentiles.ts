// Percentiles of an array, from its histogram. A few outliers make the bars of a histogram too wide. Therefore further
// histograms are computed over narrower ranges.
import type { Range } from "../generated/protocol";

export interface Counts {
  range: Range;
  counts: readonly number[];
  below: number;
  above: number;
}

/** Computes a histogram over a range. null: the range of the array. */
export type Count = (range: Range | null) => Promise<Counts>;

const MOST_LOOKS = 12;
/** A result narrower than this fraction of the histogram's range is refined by a histogram over the result. */
const WIDE_ENOUGH = 0.125;

/** Returns the lower edge of the bar with the first quantile and the upper edge of the bar with the second quantile. */
function between({ range: [low, high], counts, below }: Counts, shares: readonly [number, number], all: number): Range {
  const width = (high - low) / counts.length;
  let seen = below;
  let [first, last] = [low, high];
  let isFirst = true;
  for (const [i, count] of counts.entries()) {
    seen += count;
    if (isFirst && seen > shares[0] * all) [first, isFirst] = [low + i * width, false];
    if (seen >= shares[1] * all) {
      last = low + (i + 1) * width;
      break;
    }
  }
  return [first, last];
}

/** Returns the range between two quantiles, or null if there are no values. `shares`: the quantiles, from 0 to 1. */
export async function percentiles(count: Count, shares: readonly [number, number]): Promise<Range | null> {
  let found = await count(null);
  const all = found.counts.reduce((sum, n) => sum + n, found.below + found.above);
  if (all === 0) return null;
  for (let look = 1; look < MOST_LOOKS; look += 1) {
    const [low, high] = between(found, shares, all);
    const [from, to] = found.range;
    if (!(high > low) || high - low >= WIDE_ENOUGH * (to - from)) break;
    found = await count([low, high]);
  }
  return between(found, shares, all);
}
