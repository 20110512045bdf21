// Color scales from a scene's coloring and the range of the data, by the rules of server/geometry/color_scale_of.cpp.
import type { ColorScale } from "./color_scale";
import { DEFAULT_MAP, missingHex } from "./color_maps";
import type { Coloring, Range } from "../generated/protocol";
import { clamp } from "./numbers";

/** Decades below the largest value on a logarithmic scale whose lowest value is not above zero. */
const LOG_DECADES = 6;
/** For larger ends of a range, the reciprocal of the width, which shaders use, would be a denormal 32-bit float. */
const LARGEST = 4e37;
/** Smallest end of a logarithmic scale. Smaller 32-bit floats have fewer digits. */
const SMALLEST_OF_LOG = 1e-37;

export function rangeAboveZero([low, high]: Range): Range {
  if (!(high > 0)) return [1, 10]; // no value is colored in this case, see isShownBy()
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

/** `data`: range of the array at the shown time step. */
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

/** False for a logarithmic scale without an explicit range, if no data value is above zero. */
export const isShownBy = (coloring: Coloring, data: Range): boolean =>
  coloring.log !== true || coloring.symmetric === true || Boolean(coloring.range) || data[1] > 0;
