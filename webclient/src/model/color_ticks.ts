// Positions and labels of a legend's ticks: the twin of server/annotations/color_ticks.cpp.
import { hasWidth, isLogOfBothSigns, LINEAR_SHARE, placeOf, valueAtPlace, type ColorScale } from "./color_scale";
import type { Range } from "../generated/protocol";
import { clamp } from "./numbers";
import { commonExponent, niceScale, numberAlone, numberLabel } from "./ticks";

export interface ColorTick {
  value: number;
  /** Along the bar, from 0 at its lower end to 1. */
  at: number;
  /** Empty: a tick without a label. */
  label: string;
}

/** Limit for steps and decades: more labels would overlap. */
const MOST_LABELS = 10;
const MOST_MARKED_DECADES = 8;

/** Common power of ten of a scale's labels, shown in its title; 0 on a logarithmic scale. */
export const exponentOf = (scale: ColorScale): number => (scale.log ? 0 : commonExponent(...scale.range));

/**
 * Label of a value beside the scale. A logarithmic bar that spans a decade or more has three digits: more cannot be
 * read off it.
 */
export const labelOn = (scale: ColorScale, value: number): string =>
  scale.log
    ? numberAlone(value, scale.range[1] >= 10 * scale.range[0] ? 3 : 6)
    : numberLabel(value, hasWidth(scale) ? scale.range[1] - scale.range[0] : 0, exponentOf(scale));

function tick(scale: ColorScale, value: number, label: string): ColorTick {
  return { value, at: clamp(placeOf(scale, value), 0, 1), label };
}

/** Smallest stride of marked step bounds that divides `strideOfLabels` and gives at most `most` marks. */
function strideOfMarks(steps: number, strideOfLabels: number, most: number): number {
  for (let stride = 1; stride < strideOfLabels; stride += 1)
    if (strideOfLabels % stride === 0 && Math.floor(steps / stride) < most) return stride;
  return strideOfLabels;
}

function stepTicks(scale: ColorScale, most: number): ColorTick[] {
  const ofLabels = Math.ceil(scale.steps / MOST_LABELS);
  const stride = strideOfMarks(scale.steps, ofLabels, most);
  const found: ColorTick[] = [];
  for (let k = 0; k <= scale.steps; k += stride) {
    const toTheEnd = scale.steps - k;
    if (toTheEnd > 0 && toTheEnd * most < scale.steps) continue; // too close to the end's mark
    const value = valueAtPlace(scale, k / scale.steps);
    found.push(tick(scale, value, k % ofLabels === 0 ? labelOn(scale, value) : ""));
  }
  return found;
}

const roundTicks = (scale: ColorScale, most: number): ColorTick[] =>
  niceScale(...scale.range, most).ticks.map(({ value, label }) => tick(scale, value, label));

/** Ticks at 1, 2 ... 9 times each power of ten; multiples in `labelled` have labels, on every `stride`-th power. */
function decadeTicks(
  scale: ColorScale,
  labelled: readonly number[],
  stride: number,
  [low, high]: Range = scale.range,
): ColorTick[] {
  const first = Math.floor(Math.log10(low));
  const last = Math.floor(Math.log10(high) + 1e-9);
  const multiples = last - first <= MOST_MARKED_DECADES ? 9 : 1;
  const found: ColorTick[] = [];
  for (let decade = first; decade <= last; decade += 1) {
    for (let multiple = 1; multiple <= multiples; multiple += 1) {
      const value = Number(`${multiple}e${decade}`);
      if (value < low * (1 - 1e-6) || value > high * (1 + 1e-6)) continue;
      const isLabelled = labelled.includes(multiple) && decade % stride === 0;
      found.push(tick(scale, value, isLabelled ? labelOn(scale, value) : ""));
    }
  }
  return found;
}

/** Zero, and the decades beyond the nearly linear part on both sides; only powers of ten have labels. */
function ticksOfBothSigns(scale: ColorScale): ColorTick[] {
  const [, reach] = scale.range;
  const above = decadeTicks(scale, [1], 1, [LINEAR_SHARE * reach, reach]);
  const below = above.map(({ value, label }) => tick(scale, -value, label === "" ? "" : labelOn(scale, -value)));
  return [...below.reverse(), tick(scale, 0, labelOn(scale, 0)), ...above];
}

function logTicks(scale: ColorScale, most: number): ColorTick[] {
  const [low, high] = scale.range;
  const stride = Math.max(1, Math.ceil(Math.floor(Math.log10(high / low)) / MOST_LABELS));
  for (const labelled of [[1], [1, 2, 5]]) {
    const found = decadeTicks(scale, labelled, stride);
    if (found.filter(({ label }) => label !== "").length >= 3) return found;
  }
  return roundTicks(scale, most);
}

/**
 * Ticks in ascending order, inside the range; one tick for a range without width. With more than `mostMarks` step
 * bounds only some are marked.
 */
export function colorTicks(scale: ColorScale, most = 6, mostMarks = Infinity): ColorTick[] {
  const [low] = scale.range;
  if (!hasWidth(scale)) return [tick(scale, low, labelOn(scale, low))];
  if (scale.steps > 1) return stepTicks(scale, mostMarks);
  if (isLogOfBothSigns(scale)) return ticksOfBothSigns(scale);
  return scale.log ? logTicks(scale, most) : roundTicks(scale, most);
}
