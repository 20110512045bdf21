// Contour lines of a slice: the contour values, and the change that is needed when the user chooses another array.
import { DEFAULT_MAP } from "./color_maps";
import { LIMITS, type Coloring, type Contours, type Range } from "../generated/protocol";

export const DEFAULT_COUNT = 10;
export const COUNTS = LIMITS.Contours.count;

/** Merge patch of a slice's contours. A member that is null is removed. */
export type ContoursChange = {
  [K in keyof Contours]?: K extends "coloring" ? object | null : Contours[K] | null;
};

/**
 * Returns the contour values that the server uses if no values are listed. The values are evenly spaced inside the
 * range, without the ends of the range, and rounded to 6 significant digits.
 */
export function evenValues({ count = DEFAULT_COUNT, range }: Contours, data: Range): number[] {
  const [low, high] = range ?? data;
  return Array.from({ length: count }, (_, i) => Number((low + ((high - low) * (i + 1)) / (count + 1)).toPrecision(6)));
}

/** Returns a color map that differs from the slice's color map, so that the contour lines are visible on the slice. */
export const mapBeside = (slice: Coloring | undefined): string =>
  slice?.array !== undefined && (slice.map ?? DEFAULT_MAP) === DEFAULT_MAP ? "inferno" : DEFAULT_MAP;

/** Returns the change that chooses another array and removes the values and ranges of the previous array. */
export const ofArray = ({ coloring }: Contours, array: string): ContoursChange => ({
  array,
  values: null,
  range: null,
  ...(coloring && { coloring: { array: null, range: null } }),
});
