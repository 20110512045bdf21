// Ticks and labels of a scale: the twin of server/annotations/ticks.cpp. tests/support/tick_cases.json tests both, so
// that the page and its saved pictures agree.
import { clamp, MINUS, superscript } from "./numbers";

export interface Tick {
  value: number;
  /** To be multiplied by 10^exponent of the scale. */
  label: string;
}

export interface Scale {
  /** In ascending order. */
  ticks: Tick[];
  /** Written once beside the scale, not at every tick. */
  exponent: number;
}

const MOST_DECIMALS = 15;
const SMALLEST_SPAN = 1e-300; // below it steps lose their digits
// Numbers from 0.001 to 9,999,999 are written out: coordinates of a map grid have seven digits before the point.
const SMALLEST_PLAIN = -3;
const LARGEST_PLAIN = 6;
const DIGITS_OF_ENDS = 6; // ends are floats: 0.0001 is a little less than 1e-4

const magnitude = (value: number): number => Math.floor(Math.log10(value));
/** Magnitude after rounding to `digits` digits: 9.9996 is 10 with three. */
const roundedMagnitude = (value: number, digits: number): number =>
  Number(value.toExponential(clamp(digits - 1, 0, MOST_DECIMALS)).split("e")[1]);
const isPlain = (exponent: number): boolean => exponent >= SMALLEST_PLAIN && exponent <= LARGEST_PLAIN;

/** Power of ten to factor out of a number with absolute value `size` > 0, written with `digits` digits. */
function takenOut(size: number, digits: number): number {
  const exponent = isPlain(magnitude(size)) ? 0 : roundedMagnitude(size, digits);
  return isPlain(exponent) ? 0 : exponent;
}

const powerOfTen = (exponent: number): string => `10${superscript(String(exponent))}`;

/** " ×10⁵", or nothing for 0. */
export const timesPowerOfTen = (exponent: number): string => (exponent === 0 ? "" : ` \u00d7${powerOfTen(exponent)}`);

function withDecimals(value: number, decimals: number): string {
  const text = value.toFixed(clamp(decimals, 0, MOST_DECIMALS));
  const isZero = Number(text) === 0;
  return text.replace("-", isZero ? "" : MINUS);
}

const withoutTrailingZeros = (text: string): string => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);

/** Common power of ten of a scale's labels; 0 if they are readable without it. */
export function commonExponent(low: number, high: number): number {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  return largest > 0 && Number.isFinite(largest) ? takenOut(largest, DIGITS_OF_ENDS) : 0;
}

/** Label with enough digits to distinguish thousandths of `span`; no trailing zeros. */
export function numberLabel(value: number, span: number, exponent: number): string {
  if (!Number.isFinite(value)) return "n/a";
  const size = span > 0 && Number.isFinite(span) ? span : Math.abs(value);
  if (!(size > 0)) return "0";
  return withoutTrailingZeros(withDecimals(value * 10 ** -exponent, 2 - magnitude(size) + exponent));
}

/** A single number with at most `digits` digits and its own power of ten: a time, or a label of a logarithmic scale. */
export function numberAlone(value: number, digits = 6): string {
  if (!Number.isFinite(value)) return "n/a";
  const exponent = value === 0 ? 0 : takenOut(Math.abs(value), digits);
  const mantissa = value * 10 ** -exponent;
  if (!Number.isFinite(mantissa)) return "n/a";
  const places = mantissa === 0 ? 0 : magnitude(Math.abs(mantissa));
  const text = withoutTrailingZeros(withDecimals(mantissa, digits - 1 - places));
  return exponent !== 0 && text === "1" ? powerOfTen(exponent) : text + timesPowerOfTen(exponent);
}

function multiples(low: number, high: number, step: number): [first: number, last: number] {
  const slack = (1e-9 * (high - low)) / step; // includes a multiple at an end in spite of rounding
  return [Math.ceil(low / step - slack), Math.floor(high / step + slack)];
}

function niceStep(low: number, high: number, most: number): { size: number; power: number } {
  for (let power = magnitude((high - low) / most); ; power += 1) {
    for (const digit of [1, 2, 5]) {
      const size = Number(`${digit}e${power}`);
      const [first, last] = multiples(low, high, size);
      if (last - first + 1 <= most) return { size, power };
    }
  }
}

/**
 * Ticks at multiples of 1, 2 or 5 times a power of ten between low and high, as many as possible but at most `most`.
 * One tick if the range has no width; none if an end is not finite or low > high.
 */
export function niceScale(low: number, high: number, most: number): Scale {
  if (!Number.isFinite(low) || !Number.isFinite(high) || low > high || most < 1) return { ticks: [], exponent: 0 };
  const exponent = commonExponent(low, high);
  const span = high - low;
  const rounding = Math.max(1e-13 * Math.max(Math.abs(low), Math.abs(high)), SMALLEST_SPAN);
  if (!(span > rounding) || !Number.isFinite(span))
    return { ticks: [{ value: low, label: numberLabel(low, 0, exponent) }], exponent };
  const step = niceStep(low, high, most);
  const [first, last] = multiples(low, high, step.size);
  const ticks = Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => {
    const value = (first + i) * step.size;
    return { value, label: withDecimals(value * 10 ** -exponent, exponent - step.power) };
  });
  return { ticks, exponent };
}
