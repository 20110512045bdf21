// Converts a histogram to one SVG path that is 100 units wide. Iso-values and opacity curves are drawn over this path.
import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { barHeights, fractionOf } from "../../model/numbers";

const ABOVE = 4; // units left free above the highest bar

interface BarsOptions {
  range: Range;
  height: number;
  logarithmicCounts: boolean;
  logarithmicAxis: boolean;
}

export function histogramBars(histogram: Histogram | null, options: BarsOptions): string {
  if (histogram === null) return "";
  const { range, height: whole, logarithmicCounts, logarithmicAxis } = options;
  const heights = barHeights(histogram.counts, logarithmicCounts);
  const [low, high] = histogram.range;
  const edge = (bin: number): number =>
    100 * fractionOf(low + ((high - low) * bin) / heights.length, range, logarithmicAxis);
  return heights
    .map((height, i) =>
      height > 0 ? `M${edge(i)} ${whole}v${-height * (whole - ABOVE)}H${edge(i + 1)}V${whole}z` : "",
    )
    .join("");
}
