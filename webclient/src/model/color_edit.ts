// Edits of a coloring. The functions with... return the changed members of the coloring, and remove the members that
// are incompatible with the change.
import { colorRow, hexOf, rangeAboveZero, type ColorScale } from "./color_scale";
import { LIMITS, type Coloring, type ColorPoint, type Range } from "../generated/protocol";
import { withEnd } from "./numbers";

/** Changed members of a coloring. A member that is undefined is removed. */
export type ColoringChange = { [K in keyof Coloring]?: Coloring[K] | undefined };

export const [, MOST_POINTS] = LIMITS.Coloring.points;
const FIRST_POINTS = 5;

/**
 * Switches a logarithmic scale on or off. `before`: the coloring before the scale was switched on. Switching off
 * restores `symmetric` and `range` of `before`. A range that the user has changed in between is kept. If the array has
 * changed, nothing is restored.
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

/** The scale is logarithmic on both sides of zero if both members are set. */
export const withSymmetricLog = (on: boolean): ColoringChange =>
  on ? { symmetric: true, log: true } : { symmetric: undefined, log: undefined };

/** The ends may be in any order. Returns an error sentence if a logarithmic scale would start at or below zero. */
export function withRange({ log, symmetric }: Coloring, a: number, b: number): ColoringChange | string {
  const range: Range = a <= b ? [a, b] : [b, a];
  if (log === true && symmetric !== true && range[0] <= 0)
    return "A logarithmic scale begins above zero; type a value above zero";
  if (symmetric !== true) return { range };
  const reach = Math.max(Math.abs(range[0]), Math.abs(range[1]));
  return { range: [-reach, reach] };
}

export function withDataRange(coloring: Coloring, values: Range): ColoringChange | string {
  const isOneSided = coloring.log === true && coloring.symmetric !== true;
  return withRange(coloring, ...(isOneSided ? rangeAboveZero(values) : values));
}

/**
 * Moves one end of the range `shown` to `to`. If `to` is beyond the other end, both ends become `to`. A symmetric scale
 * gets the range from -|to| to |to|.
 */
export function withRangeEnd(coloring: Coloring, shown: Range, end: 0 | 1, to: number): ColoringChange | string {
  const range = coloring.symmetric === true ? ([to, to] as const) : withEnd(shown, end, to);
  return withRange(coloring, ...range);
}

export const withMap = (map: string): ColoringChange => ({ map, points: undefined });

/** Returns initial custom color points, sampled from the scale's current colors. */
export function pointsOf(scale: ColorScale): ColorPoint[] {
  const smooth = { ...scale, steps: 0, reverse: false };
  return colorRow(smooth, FIRST_POINTS).map((color, i) => ({ at: i / (FIRST_POINTS - 1), color: hexOf(color) }));
}

export function movedPoint(points: readonly ColorPoint[], index: number, at: number): ColorPoint[] {
  const low = points[index - 1]?.at ?? 0;
  const high = points[index + 1]?.at ?? 1;
  return points.map((point, i) => (i === index ? { ...point, at: Math.min(high, Math.max(low, at)) } : point));
}

/** Adds a point in the middle of the widest gap between two points. `colorAt`: the scale's color at a position. */
export function addedPoint(points: readonly ColorPoint[], colorAt: (place: number) => string): ColorPoint[] {
  let best = 0;
  const gap = (i: number): number => (points[i + 1]?.at ?? 0) - (points[i]?.at ?? 0);
  for (let i = 1; i + 1 < points.length; i += 1) if (gap(i) > gap(best)) best = i;
  const at = ((points[best]?.at ?? 0) + (points[best + 1]?.at ?? 1)) / 2;
  return [...points.slice(0, best + 1), { at, color: colorAt(at) }, ...points.slice(best + 1)];
}
