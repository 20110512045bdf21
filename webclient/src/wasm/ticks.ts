// Ticks of a scale and numbers as text, by server/annotations/ticks.hpp.
import { call } from "./layout_module";

export interface Tick {
  value: number;
  /** Mantissa of the value. The power of ten is the scale's `exponent`. */
  label: string;
}

export interface Scale {
  /** Ticks in ascending order. */
  ticks: Tick[];
  /** Common power of ten of the labels. It is written once beside the scale. */
  exponent: number;
}

/**
 * Returns ticks at multiples of a step between low and high. The step is 1, 2 or 5 times a power of ten, the smallest
 * that gives at most `most` ticks. One tick if the range has no width; none if an end is not finite or low > high.
 */
export function niceScale(low: number, high: number, most: number): Scale {
  const results = call("nice_scale", low, high, most);
  const exponent = results.number();
  return { exponent, ticks: results.list(() => ({ value: results.number(), label: results.text() })) };
}

/** Common power of ten to factor out of a scale's labels. 0 if the labels are readable without it. */
export const commonExponent = (low: number, high: number): number => call("common_exponent", low, high).number();

/**
 * Mantissa of a value with digits down to about a thousandth of `span`, without trailing zeros. `exponent`: power of ten
 * that is factored out.
 */
export const numberLabel = (value: number, span: number, exponent: number): string =>
  call("number_label", value, span, exponent).text();

/** Formats a single number with at most `digits` digits and its own power of ten. */
export const numberAlone = (value: number, digits = 6): string => call("number_alone", value, digits).text();

/** Factor to append to a number, as in " ×10⁵". Empty for exponent 0. */
export const timesPowerOfTen = (exponent: number): string => call("times_power_of_ten", exponent).text();

/** Units with superscripts: m^2/s^2 becomes m²/s². */
export const prettyUnits = (units: string): string => call("pretty_units", units).text();
