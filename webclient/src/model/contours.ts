// Contour lines of a slice: where they lie, and what becomes of them when a hand changes what they are of.
import { DEFAULT_MAP } from "./color_maps";
import type { Coloring, Contours, Range } from "../generated/protocol";

export const DEFAULT_COUNT = 10;
export const MOST_COUNT = 64;

/** null takes a member away. */
export type ContoursChange = {
  [K in keyof Contours]?: K extends "coloring" ? object | null : Contours[K] | null;
};

/** As the server spreads them: evenly inside the range, its ends left out; with digits that can be read. */
export function evenValues({ count = DEFAULT_COUNT, range }: Contours, data: Range): number[] {
  const [low, high] = range ?? data;
  return Array.from({ length: count }, (_, i) => Number((low + ((high - low) * (i + 1)) / (count + 1)).toPrecision(6)));
}

/** A map whose lines are seen on a slice of these colors: not the slice's own. */
export const mapBeside = (slice: Coloring | undefined): string =>
  slice?.array !== undefined && (slice.map ?? DEFAULT_MAP) === DEFAULT_MAP ? "inferno" : DEFAULT_MAP;

/** The lines of another array: the values and the ranges belonged to the one before. */
export const ofArray = ({ coloring }: Contours, array: string): ContoursChange => ({
  array,
  values: null,
  range: null,
  ...(coloring && { coloring: { array: null, range: null } }),
});
