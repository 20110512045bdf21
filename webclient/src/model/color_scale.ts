// Maps scalars to colors by the rules of protocol/colors.md. The server uses the same rules
// (server/color/color_scale.hpp). The cases in tests/support/color_cases.json test both.
import type { ColorPoint, Range } from "../generated/protocol";
import type { ScaleInBytes } from "../wasm/overlay";
import { colorMap, knownMap } from "./color_maps";

export type Rgb8 = readonly [number, number, number];

export interface ColorScale {
  map: string;
  /** Two or more custom color points replace the map. Empty: the map is used. */
  points: readonly ColorPoint[];
  /** Lowest and highest value of the scale. A logarithmic range is above zero, or from -r to r. */
  range: Range;
  reverse: boolean;
  log: boolean;
  /** Number of discrete colors; 0: smooth. */
  steps: number;
  nan: string;
  below: string | null;
  above: string | null;
}

export function bytesOf(hex: string): Rgb8 {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)) as unknown as Rgb8;
}

export const hexOf = (color: readonly number[]): string =>
  `#${color.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;

const bytesIfAny = (hex: string | null): Rgb8 | null => (hex === null ? null : bytesOf(hex));

/** Replaces a map that the page does not have, because the layout has only the page's own color maps. */
export const inBytes = ({ map, points, nan, below, above, ...rest }: ColorScale): ScaleInBytes => ({
  ...rest,
  map: knownMap(map),
  points: points.map(({ at, color }) => ({ at, color: bytesOf(color) })),
  nan: bytesOf(nan),
  below: bytesIfAny(below),
  above: bytesIfAny(above),
});

function between(a: Rgb8, b: Rgb8, share: number): Rgb8 {
  return a.map((channel, k) => Math.round(channel + share * ((b[k] ?? 0) - channel))) as unknown as Rgb8;
}

function ofTable(map: string, at: number): Rgb8 {
  const table = colorMap(map);
  const index = Math.min(1, Math.max(0, at)) * 255;
  const color = (entry: number): Rgb8 => [...table.subarray(4 * entry, 4 * entry + 3)] as unknown as Rgb8;
  const first = Math.floor(index);
  return between(color(first), color(Math.min(first + 1, 255)), index - first);
}

function ofPoints(points: readonly ColorPoint[], at: number): Rgb8 {
  const found = points.findIndex((point) => point.at > at);
  const next = found < 0 ? points.length : found;
  const low = points[Math.max(0, next - 1)];
  const high = points[Math.min(next, points.length - 1)];
  if (low === undefined || high === undefined) return [0, 0, 0];
  const share = next === 0 || high.at === low.at ? 0 : (at - low.at) / (high.at - low.at);
  return between(bytesOf(low.color), bytesOf(high.color), share);
}

function smoothColor(scale: ColorScale, place: number): Rgb8 {
  const at = scale.reverse ? 1 - place : place;
  return scale.points.length > 0 ? ofPoints(scale.points, at) : ofTable(scale.map, at);
}

function innerColor(scale: ColorScale, place: number): Rgb8 {
  const { steps } = scale;
  if (steps < 2) return smoothColor(scale, place);
  return smoothColor(scale, Math.min(steps - 1, Math.max(0, Math.floor(place * steps))) / (steps - 1));
}

/** From the lower to the upper end of the scale. On a scale with steps, each color is the color of its step. */
export const colorsAlong = (scale: ColorScale, count: number): Rgb8[] =>
  Array.from({ length: count }, (_, i) => innerColor(scale, count > 1 ? i / (count - 1) : 0.5));

/** Returns one color for each step. For a scale without steps, returns `smoothCount` colors for interpolation. */
export const colorRow = (scale: ColorScale, smoothCount: number): Rgb8[] =>
  colorsAlong({ ...scale, steps: 0 }, scale.steps > 1 ? scale.steps : smoothCount);

export function hasWidth({ range: [low, high] }: ColorScale): boolean {
  const width = Math.fround(high - low);
  return Number.isFinite(width) && width > 0;
}

/** Up to this fraction of the upper end, a scale that is logarithmic on both sides of zero is nearly linear. */
export const LINEAR_SHARE = 1e-3;
const LOG_OF_REACH = Math.log1p(1 / LINEAR_SHARE);

export const isLogOfBothSigns = ({ log, range: [low] }: ColorScale): boolean => log && low < 0;

/** Returns the position of a value: 0 at the lower end, 1 at the upper end, 0.5 for a range without width. */
export function placeOf(scale: ColorScale, value: number): number {
  if (!hasWidth(scale)) return 0.5;
  const [low, high] = scale.range;
  if (!scale.log) return (value - low) / (high - low);
  if (isLogOfBothSigns(scale))
    return 0.5 + (Math.sign(value) * Math.log1p(Math.abs(value) / (LINEAR_SHARE * high))) / (2 * LOG_OF_REACH);
  return value <= 0 ? -Infinity : Math.log(value / low) / Math.log(high / low);
}

export function valueAtPlace(scale: ColorScale, place: number): number {
  const [low, high] = scale.range;
  if (!hasWidth(scale)) return low;
  if (place === 1) return high; // avoids a rounding error
  if (isLogOfBothSigns(scale)) {
    const fromMiddle = 2 * place - 1;
    return Math.sign(fromMiddle) * LINEAR_SHARE * high * Math.expm1(Math.abs(fromMiddle) * LOG_OF_REACH);
  }
  return scale.log ? low * (high / low) ** place : low + place * (high - low);
}

/** As a fraction of the range's width. A narrow range far from zero needs no more, because its values are doubles. */
const LARGEST_SLACK = 1e-3;

/** Values outside these limits get the color `below` or `above`. The limits allow for 32-bit rounding errors. */
export function limitsOf(scale: ColorScale): Range {
  if (!hasWidth(scale)) return [-Infinity, Infinity];
  const [low, high] = scale.range;
  if (scale.log && low > 0) return [low * (1 - 1e-6), high * (1 + 1e-6)];
  const width = high - low;
  const rounding = 2.5e-7 * Math.max(Math.abs(low), Math.abs(high));
  const slack = 1e-6 * width + Math.min(rounding, LARGEST_SLACK * width);
  return [low - slack, high + slack];
}

export function colorOf(scale: ColorScale, value: number): Rgb8 {
  if (!Number.isFinite(value)) return bytesOf(scale.nan);
  const [lowest, highest] = limitsOf(scale);
  if (value < lowest && scale.below !== null) return bytesOf(scale.below);
  if (value > highest && scale.above !== null) return bytesOf(scale.above);
  return innerColor(scale, Math.min(1, Math.max(0, placeOf(scale, value))));
}
