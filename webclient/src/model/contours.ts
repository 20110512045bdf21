// Contour lines of a slice: their values, and the changes that follow from another array.
import { DEFAULT_MAP } from "./color_maps";
import type { Coloring, Contours, Range } from "../generated/protocol";

export const DEFAULT_COUNT = 10;
export const MOST_COUNT = 64;

/** null removes a member. */
export type ContoursChange = {
  [K in keyof Contours]?: K extends "coloring" ? object | null : Contours[K] | null;
};

/** Same values as the server: evenly spaced inside the range without its ends. Rounded to 6 digits. */
export function evenValues({ count = DEFAULT_COUNT, range }: Contours, data: Range): number[] {
  const [low, high] = range ?? data;
  return Array.from({ length: count }, (_, i) => Number((low + ((high - low) * (i + 1)) / (count + 1)).toPrecision(6)));
}

/** A map other than the slice's, so that its lines are visible on the slice. */
export const mapBeside = (slice: Coloring | undefined): string =>
  slice?.array !== undefined && (slice.map ?? DEFAULT_MAP) === DEFAULT_MAP ? "inferno" : DEFAULT_MAP;

/** Switches to another array and drops the values and ranges of the previous one. */
export const ofArray = ({ coloring }: Contours, array: string): ContoursChange => ({
  array,
  values: null,
  range: null,
  ...(coloring && { coloring: { array: null, range: null } }),
});
