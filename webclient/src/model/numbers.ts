// Formatting, parsing and rounding of values, and their positions on a slider.
import type { Range } from "../generated/protocol";

export const MINUS = "\u2212";

/** Enough digits to tell apart values that differ by a thousandth of the span. */
export function formatNumber(value: number, span = Math.abs(value)): string {
  if (!Number.isFinite(value)) return "n/a";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const resolution = span > 0 && Number.isFinite(span) ? span / 1000 : size / 1000;
  const places = Math.floor(Math.log10(size));
  const wanted = places - Math.floor(Math.log10(resolution)) + 1;
  const digits = Math.min(15, Math.max(1, wanted, size < 1e6 ? places + 1 : 1)); // whole numbers are not rounded
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(Math.min(digits - 1, 5)) : value.toPrecision(digits);
  const [mantissa = "", exponent] = text.split("e");
  const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  return (exponent === undefined ? short : `${short}e${exponent.replace("+", "")}`).replaceAll("-", MINUS);
}

// Groups of three digits after one to three digits, the first not 0: separated by spaces (thin, no-break or plain, as
// formatCount writes them) or by commas.
const SPACED = /^[-+]?[1-9]\d{0,2}(?:[ \u00a0\u2009\u202f]\d{3})+(?![\d ])/;
const COMMAS = /^[-+]?[1-9]\d{0,2}(?:,\d{3})+(?=\.|$|e)/i;
const EITHER = /^[-+]?[1-9]\d{0,2},\d{3}(?=$|e)/i;

const withHyphen = (text: string): string => text.trim().replaceAll(MINUS, "-");

function withoutGroups(text: string): string {
  const spaced = text.replace(SPACED, (digits) => digits.replace(/\s/g, ""));
  return spaced.replace(COMMAS, (digits) => digits.replaceAll(",", "")).replace(",", ".");
}

/** null where the text is not one finite number. Accepts what formatNumber and formatCount write. */
export function parseNumber(text: string): number | null {
  const typed = withHyphen(text);
  if (typed === "" || EITHER.test(typed)) return null;
  const value = Number(withoutGroups(typed));
  return Number.isFinite(value) ? value : null;
}

/** Why parseNumber rejects the text. One comma before three digits is ambiguous: thousands or a decimal point. */
export function whyNoNumber(text: string): string {
  const typed = withHyphen(text);
  if (typed === "") return "A number is expected here";
  if (!EITHER.test(typed)) return `"${text}" is not a number that can be used`;
  return `"${text}" can be read in two ways; write ${typed.replace(",", "")} or ${typed.replace(",", ".")}`;
}

const SUPERSCRIPTS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";

/** An integer's digits and minus sign as superscripts. */
export const superscript = (digits: string): string =>
  digits.replace(/\d/g, (digit) => SUPERSCRIPTS.charAt(Number(digit))).replace("-", "\u207b");

/** Units with superscript exponents: m^2/s^2 as m²/s². */
export const prettyUnits = (units: string): string =>
  units.replace(/\^(-?\d+)/g, (_, digits: string) => superscript(digits));

export const formatCount = (count: number): string => count.toLocaleString("en-US").replaceAll(",", "\u202f");

export const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

/** The range with one end set to `to`; it pushes the other end so that the range stays ordered. */
export const withEnd = ([low, high]: Range, end: 0 | 1, to: number): Range =>
  end === 0 ? [to, Math.max(to, high)] : [Math.min(to, low), to];

/** Power of ten of at most a thousandth of the range, so that a drag gives round values. */
export function niceStep([low, high]: Range): number {
  const span = high - low;
  return span > 0 ? 10 ** Math.floor(Math.log10(span / 1000)) : 1;
}

/** A slider over the range. Its step is 1, 2 or 5 times a power of ten and at most a two-hundredth of the range. Its
 * positions are multiples of the step; the track ends at the first multiple past each end. */
export function sliderTrack([low, high]: Range): { min: number; max: number; step: number } {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return { min: low, max: high, step: 1 };
  const power = 10 ** Math.floor(Math.log10(span / 200));
  const step = Number((([5, 2].find((n) => n * power <= span / 200) ?? 1) * power).toPrecision(1));
  const end = (round: (steps: number) => number, value: number): number =>
    Number((round(Number((value / step).toPrecision(12))) * step).toPrecision(12));
  return { min: end(Math.floor, low), max: end(Math.ceil, high), step };
}

/** Most decades of a logarithmic slider. */
const DECADES = 6;

/** Start of a logarithmic slider over the range; null if the range has values below zero or no width. */
export function logarithmicStart([low, high]: Range): number | null {
  const start = Math.max(low, high / 10 ** DECADES);
  return low >= 0 && start > 0 && start < high ? start : null;
}

export function valueAt(fraction: number, range: Range, logarithmic = false): number {
  const [low, high] = range;
  const f = clamp(fraction, 0, 1);
  if (f === 0 || f === 1) return f === 0 ? low : high;
  const start = logarithmic ? logarithmicStart(range) : null;
  if (start !== null) return clamp(Number((start * (high / start) ** f).toPrecision(3)), low, high);
  const step = niceStep(range);
  const rounded = Number((Math.round((low + f * (high - low)) / step) * step).toPrecision(12));
  return clamp(rounded, low, high);
}

export function fractionOf(value: number, [low, high]: Range, logarithmic = false): number {
  const start = logarithmic ? logarithmicStart([low, high]) : null;
  if (start !== null) return value <= start ? 0 : clamp(Math.log(value / start) / Math.log(high / start), 0, 1);
  return high > low ? clamp((value - low) / (high - low), 0, 1) : 0.5;
}

/** Bar heights from 0 to 1. Logarithmic counts keep rare values visible. */
export function barHeights(counts: readonly number[], logarithmic: boolean): number[] {
  const measure = (count: number): number => (logarithmic ? Math.log1p(count) : count);
  const top = measure(counts.reduce((most, count) => Math.max(most, count), 0));
  return counts.map((count) => (top > 0 ? measure(count) / top : 0));
}

/** Rounded middle of the widest gap between values and the ends of the range. */
export function widestGap(values: readonly number[], [low, high]: Range): number {
  const stops = [low, ...values.filter((v) => v > low && v < high).sort((a, b) => a - b), high];
  let best = 0;
  for (let i = 1; i + 1 < stops.length; i += 1) {
    if ((stops[i + 1] ?? 0) - (stops[i] ?? 0) > (stops[best + 1] ?? 0) - (stops[best] ?? 0)) best = i;
  }
  return valueAt(fractionOf(((stops[best] ?? low) + (stops[best + 1] ?? high)) / 2, [low, high]), [low, high]);
}
