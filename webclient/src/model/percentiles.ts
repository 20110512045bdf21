// Percentiles of an array's values from histograms that zoom in: with a few outliers, the bars of the first histogram
// are too wide.
import type { Range } from "../generated/protocol";

export interface Counts {
  range: Range;
  counts: readonly number[];
  below: number;
  above: number;
}

/** Counts values in a range; null for the array's own range. */
export type Count = (range: Range | null) => Promise<Counts>;

const MOST_LOOKS = 12;
/** Share of a histogram's range: a narrower result is counted again with narrower bars. */
const WIDE_ENOUGH = 0.125;

/** From the lower edge of the bar that exceeds the first share of all values to the upper edge of the second's bar. */
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

/** The range between two shares (0 to 1) of the values; null if there are no values. */
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
