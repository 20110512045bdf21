// Maps scalars to colors by the rules of protocol/colors.md. The WebAssembly module contains the server's code for this
// (server/color/color_scale.hpp).
import { DEFAULTS, type Coloring, type ColorPoint, type Range } from "../generated/protocol";
import * as wasm from "../wasm/color_scale";
import { rangeOf } from "../wasm/scale_range";
import { knownMap } from "./color_maps";

export { hasWidth, placeOf, valueAtPlace } from "../wasm/color_scale";
export { isShownBy, rangeAboveZero, rangeOf } from "../wasm/scale_range";

export type Rgb8 = wasm.Rgb8;

export interface ColorScale extends wasm.ScaleOfValues {
  map: string;
  /** Two or more custom color points replace the map. Empty: the map is used. */
  points: readonly ColorPoint[];
  range: Range;
  reverse: boolean;
  nan: string;
  below: string | null;
  above: string | null;
}

/** `data`: range of the array at the shown time step. */
export const scaleOf = (coloring: Coloring, data: Range): ColorScale => ({
  map: coloring.map ?? DEFAULTS.Coloring.map,
  points: coloring.points ?? [],
  range: rangeOf(coloring, data),
  reverse: coloring.reverse ?? DEFAULTS.Coloring.reverse,
  log: coloring.log ?? DEFAULTS.Coloring.log,
  steps: coloring.steps ?? 0,
  nan: coloring.nan ?? DEFAULTS.Coloring.nan,
  below: coloring.below ?? null,
  above: coloring.above ?? null,
});

export function bytesOf(hex: string): Rgb8 {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)) as unknown as Rgb8;
}

export const hexOf = (color: readonly number[]): string =>
  `#${color.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;

const bytesIfAny = (hex: string | null): Rgb8 | null => (hex === null ? null : bytesOf(hex));

/** Converts colors to bytes. Replaces a map that the page does not know by the default map. */
export const inBytes = ({ map, points, nan, below, above, ...rest }: ColorScale): wasm.ScaleInBytes => ({
  ...rest,
  map: knownMap(map),
  points: points.map(({ at, color }) => ({ at, color: bytesOf(color) })),
  nan: bytesOf(nan),
  below: bytesIfAny(below),
  above: bytesIfAny(above),
});

/**
 * Returns the colors at `count` evenly spaced positions from the lower to the upper end of the scale. On a scale with
 * steps, each color is the color of the step at this position.
 */
export const colorsAlong = (scale: ColorScale, count: number): Rgb8[] => wasm.colorsAlong(inBytes(scale), count);

/** Returns one color for each step. For a scale without steps, returns `smoothCount` colors for interpolation. */
export const colorRow = (scale: ColorScale, smoothCount: number): Rgb8[] => wasm.colorRow(inBytes(scale), smoothCount);

export const colorOf = (scale: ColorScale, value: number): Rgb8 => wasm.colorOf(inBytes(scale), value);

export const scaleRules = (scale: ColorScale): wasm.ScaleRules => wasm.scaleRules(inBytes(scale));
