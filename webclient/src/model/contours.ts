// Contour lines of a slice: the contour values, and the change that is needed when the user chooses another array.
import { DEFAULT_MAP } from "./color_maps";
import { DEFAULTS, LIMITS, type Coloring, type Contours, type Range } from "../generated/protocol";

export const COUNTS = LIMITS.Contours.count;

/** Merge patch: a member that is null is removed. */
export type ContoursChange = {
  [K in keyof Contours]?: K extends "coloring" ? object | null : Contours[K] | null;
};

/** Returns the values that the server uses if the scene lists none: evenly spaced, without the ends of the range. */
export function evenValues({ count = DEFAULTS.Contours.count, range }: Contours, data: Range): number[] {
  const [low, high] = range ?? data;
  return Array.from({ length: count }, (_, i) => Number((low + ((high - low) * (i + 1)) / (count + 1)).toPrecision(6)));
}

/** Returns a map for contour lines that differs from the slice's map, so that the lines are visible on the slice. */
export const mapBeside = (slice: Coloring | undefined): string =>
  slice?.array !== undefined && (slice.map ?? DEFAULT_MAP) === DEFAULT_MAP ? "inferno" : DEFAULT_MAP;

export const ofArray = ({ coloring }: Contours, array: string): ContoursChange => ({
  array,
  values: null,
  range: null,
  ...(coloring && { coloring: { array: null, range: null } }),
});
