// Places, values and colors on a color scale, computed by the code of server/color/color_scale.hpp. A place is a
// position on the scale: 0 at the lower end, 1 at the upper end.
import { call } from "./layout_module";
import type { Item, ResultReader } from "./message";

/** Red, green and blue from 0 to 255. */
export type Rgb8 = readonly [number, number, number];

/** The members of a color scale that determine the place and the label of each value. */
export interface ScaleOfValues {
  /** Lowest and highest value of the scale. A logarithmic range is above zero, or from -r to r. */
  range: readonly [number, number];
  log: boolean;
  /** Number of discrete colors; 0: smooth. */
  steps: number;
}

export interface ScaleInBytes extends ScaleOfValues {
  map: string;
  points: readonly { at: number; color: Rgb8 }[];
  reverse: boolean;
  nan: Rgb8;
  below: Rgb8 | null;
  above: Rgb8 | null;
}

const colorIfAny = (color: Rgb8 | null): Item => (color === null ? 0 : [1, color]);

export const valuesItem = ({ range, log, steps }: ScaleOfValues): Item => [range, log, steps];

export function scaleItem(scale: ScaleInBytes): Item {
  const { map, points, reverse, nan, below, above } = scale;
  const listed: Item = [points.length, points.map(({ at, color }) => [at, color])];
  return [valuesItem(scale), map, listed, reverse, nan, colorIfAny(below), colorIfAny(above)];
}

const color = (results: ResultReader): Rgb8 => [results.number(), results.number(), results.number()];

function colors(name: "colors_along" | "color_row", scale: ScaleInBytes, count: number): Rgb8[] {
  const results = call(name, scaleItem(scale), count);
  return results.list(() => color(results));
}

export const colorsAlong = (scale: ScaleInBytes, count: number): Rgb8[] => colors("colors_along", scale, count);

export const colorRow = (scale: ScaleInBytes, smoothCount: number): Rgb8[] => colors("color_row", scale, smoothCount);

export const colorOf = (scale: ScaleInBytes, value: number): Rgb8 => color(call("color_of", scaleItem(scale), value));

export const hasWidth = (scale: ScaleOfValues): boolean => call("has_width", valuesItem(scale)).number() !== 0;

/** Returns 0.5 for a range without width. */
export const placeOf = (scale: ScaleOfValues, value: number): number =>
  call("place_of", valuesItem(scale), value).number();

export const valueAtPlace = (scale: ScaleOfValues, place: number): number =>
  call("value_at", valuesItem(scale), place).number();

/** Texels of the texture scale_rules in protocol/shading/color_scale.glsl. */
export interface ScaleRules {
  /** The shader needs values minus this origin, because 32-bit floats would lose digits of a small range far from 0. */
  origin: number;
  /** Five RGBA texels. */
  texels: Float32Array<ArrayBuffer>;
}

const TEXEL_CHANNELS = 4 * 5;

export function scaleRules(scale: ScaleInBytes): ScaleRules {
  const results = call("scale_rules", scaleItem(scale));
  return { origin: results.number(), texels: Float32Array.from({ length: TEXEL_CHANNELS }, () => results.number()) };
}
