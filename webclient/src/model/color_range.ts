// Makes the drawn color scale from a scene's coloring and the range of the data. The twin of
// server/geometry/color_scale_of.cpp.
import type { ColorScale } from "./color_scale";
import { DEFAULT_MAP, missingHex } from "./color_maps";
import type { Coloring, Range } from "../generated/protocol";
import { clamp } from "./numbers";

/** Decades of a logarithmic scale below the largest value, if the data contains zero. */
const LOG_DECADES = 6;
/** Largest range end; a GPU can still divide by the width of such a range. */
const LARGEST = 4e37;
/** Smaller values lose digits as floats. */
const SMALLEST_OF_LOG = 1e-37;

export function rangeAboveZero([low, high]: Range): Range {
  if (!(high > 0)) return [1, 10]; // no data is shown: see isShownBy
  const start = low > 0 ? low : high / 10 ** LOG_DECADES;
  return [Math.max(start, SMALLEST_OF_LOG), Math.max(high, SMALLEST_OF_LOG)];
}

export function rangeOf(coloring: Coloring, data: Range): Range {
  let range = (coloring.range ?? data).map((end) => clamp(end, -LARGEST, LARGEST)) as Range;
  if (coloring.symmetric === true) {
    const reach = Math.max(Math.abs(range[0]), Math.abs(range[1]));
    range = [-reach, reach];
  }
  if (coloring.log === true && coloring.symmetric !== true) range = rangeAboveZero(range);
  return range;
}

/** data: the array's range at the shown step. */
export const scaleOf = (coloring: Coloring, data: Range): ColorScale => ({
  map: coloring.map ?? DEFAULT_MAP,
  points: coloring.points ?? [],
  range: rangeOf(coloring, data),
  reverse: coloring.reverse === true,
  log: coloring.log === true,
  steps: coloring.steps ?? 0,
  nan: coloring.nan ?? missingHex,
  below: coloring.below ?? null,
  above: coloring.above ?? null,
});

/** False if a logarithmic scale takes its range from data without a value above zero. */
export const isShownBy = (coloring: Coloring, data: Range): boolean =>
  coloring.log !== true || coloring.symmetric === true || Boolean(coloring.range) || data[1] > 0;
