// Where a legend has its marks and what stands beside them: the twin of server/render/color_ticks.cpp.
import { hasWidth, placeOf, valueAtPlace, type ColorScale } from "../display/color_scale";
import { clamp, formatNumber, ticks } from "./numbers";

export interface ColorTick {
  value: number;
  /** Along the bar, from 0 at its lower end to 1. */
  at: number;
  /** Empty: a mark alone. */
  label: string;
}

/** Of steps and decades: more would stand on each other. */
const MOST_LABELS = 10;
const MOST_MARKED_DECADES = 8;

function tick(scale: ColorScale, value: number, hasLabel: boolean, span?: number): ColorTick {
  const label = hasLabel ? formatNumber(value, span) : "";
  return { value, at: clamp(placeOf(scale, value), 0, 1), label };
}

function stepTicks(scale: ColorScale): ColorTick[] {
  const stride = Math.ceil(scale.steps / MOST_LABELS);
  const span = scale.log ? undefined : scale.range[1] - scale.range[0];
  return Array.from({ length: scale.steps + 1 }, (_, k) =>
    tick(scale, valueAtPlace(scale, k / scale.steps), k % stride === 0, span),
  );
}

/** 1, 2 ... 9 times each power of ten; those `labelled` have labels, on every `stride`-th power. */
function decadeTicks(scale: ColorScale, labelled: readonly number[], stride: number): ColorTick[] {
  const [low, high] = scale.range;
  const first = Math.floor(Math.log10(low));
  const last = Math.floor(Math.log10(high) + 1e-9);
  const multiples = last - first <= MOST_MARKED_DECADES ? 9 : 1;
  const found: ColorTick[] = [];
  for (let decade = first; decade <= last; decade += 1) {
    for (let multiple = 1; multiple <= multiples; multiple += 1) {
      const value = Number(`${multiple}e${decade}`);
      if (value < low * (1 - 1e-6) || value > high * (1 + 1e-6)) continue;
      found.push(tick(scale, value, labelled.includes(multiple) && decade % stride === 0));
    }
  }
  return found;
}

function logTicks(scale: ColorScale, wanted: number): ColorTick[] {
  const [low, high] = scale.range;
  const stride = Math.max(1, Math.ceil(Math.floor(Math.log10(high / low)) / MOST_LABELS));
  for (const labelled of [[1], [1, 2, 5]]) {
    const found = decadeTicks(scale, labelled, stride);
    if (found.filter(({ label }) => label !== "").length >= 3) return found;
  }
  return ticks([low, high], wanted).map((value) => tick(scale, value, true, high - low));
}

/** In ascending order, inside the range; one for a range without width. */
export function colorTicks(scale: ColorScale, wanted = 5): ColorTick[] {
  const [low, high] = scale.range;
  if (!hasWidth(scale)) return [tick(scale, low, true)];
  if (scale.steps > 1) return stepTicks(scale);
  if (scale.log) return logTicks(scale, wanted);
  return ticks([low, high], wanted).map((value) => tick(scale, value, true, high - low));
}
