// What a hand does to a coloring: each answers the members that change, so that what cannot stand together never does.
import { colorRow, hexOf, type ColorScale } from "./color_scale";
import type { Coloring, ColorPoint, Range } from "../generated/protocol";
import { rangeAboveZero } from "./color_range";
import { withEnd } from "./numbers";

/** undefined takes a member away. */
export type ColoringChange = { [K in keyof Coloring]?: Coloring[K] | undefined };

export const MOST_POINTS = 64;
export const MOST_STEPS = 256;
const FIRST_POINTS = 5;

/**
 * A logarithm and zero in the middle exclude each other; a given range keeps what of it lies above zero. `before`: the
 * coloring when the logarithm was switched on, whose members come back with its end unless a hand has changed them.
 */
export function withLog({ array, range }: Coloring, on: boolean, before?: Coloring): ColoringChange {
  if (!on) {
    if (before === undefined || before.array !== array) return { log: undefined };
    const { range: narrowed } = { ...before, ...withLog(before, true) };
    const isUntouched = JSON.stringify(narrowed ?? null) === JSON.stringify(range ?? null);
    return { log: undefined, symmetric: before.symmetric, ...(isUntouched && { range: before.range }) };
  }
  if (!range || range[0] > 0) return { log: true, symmetric: undefined };
  return { log: true, symmetric: undefined, range: range[1] > 0 ? rangeAboveZero(range) : undefined };
}

export const withSymmetric = (on: boolean): ColoringChange =>
  on ? { symmetric: true, log: undefined } : { symmetric: undefined };

/** Logarithmic on both sides of zero: both of them together. */
export const withSymmetricLog = (on: boolean): ColoringChange =>
  on ? { symmetric: true, log: true } : { symmetric: undefined, log: undefined };

/** A sentence where the scale has no place for that range. */
export function withRange({ log, symmetric }: Coloring, a: number, b: number): ColoringChange | string {
  const range: Range = a <= b ? [a, b] : [b, a];
  if (log === true && symmetric !== true && range[0] <= 0)
    return "A logarithmic scale begins above zero; type a value above zero";
  if (symmetric !== true) return { range };
  const reach = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  return { range: [-reach, reach] };
}

/** One end of the range that is seen, typed: it pushes the other, and both where the scale is symmetric. */
export function withRangeEnd(coloring: Coloring, shown: Range, end: 0 | 1, to: number): ColoringChange | string {
  const range = coloring.symmetric === true ? ([to, to] as const) : withEnd(shown, end, to);
  return withRange(coloring, ...range);
}

/** A map by name is shown as it is: points of one's own give way to it. */
export const withMap = (map: string): ColoringChange => ({ map, points: undefined });

/** Points to begin with: what is seen now. */
export function pointsOf(scale: ColorScale): ColorPoint[] {
  const smooth = { ...scale, steps: 0, reverse: false };
  return colorRow(smooth, FIRST_POINTS).map((color, i) => ({ at: i / (FIRST_POINTS - 1), color: hexOf(color) }));
}

/** The points with one moved, kept between its neighbours. */
export function movedPoint(points: readonly ColorPoint[], index: number, at: number): ColorPoint[] {
  const low = points[index - 1]?.at ?? 0;
  const high = points[index + 1]?.at ?? 1;
  return points.map((point, i) => (i === index ? { ...point, at: Math.min(high, Math.max(low, at)) } : point));
}

/** One more in the widest gap, of the color that is there. */
export function addedPoint(points: readonly ColorPoint[], colorAt: (place: number) => string): ColorPoint[] {
  let best = 0;
  const gap = (i: number): number => (points[i + 1]?.at ?? 0) - (points[i]?.at ?? 0);
  for (let i = 1; i + 1 < points.length; i += 1) if (gap(i) > gap(best)) best = i;
  const at = ((points[best]?.at ?? 0) + (points[best + 1]?.at ?? 1)) / 2;
  return [...points.slice(0, best + 1), { at, color: colorAt(at) }, ...points.slice(best + 1)];
}
