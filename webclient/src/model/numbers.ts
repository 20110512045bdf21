// Formats, parses and rounds values, and converts between values and positions on a slider.
import type { Range } from "../generated/protocol";

export const MINUS = "\u2212";

/** Formats a value. The digits are enough to distinguish two values that differ by a thousandth of `span`. */
export function formatNumber(value: number, span = Math.abs(value)): string {
  if (!Number.isFinite(value)) return "n/a";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const resolution = span > 0 && Number.isFinite(span) ? span / 1000 : size / 1000;
  const places = Math.floor(Math.log10(size));
  const wanted = places - Math.floor(Math.log10(resolution)) + 1;
  const digits = Math.min(15, Math.max(1, wanted, size < 1e6 ? places + 1 : 1)); // whole numbers keep all digits
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  const [mantissa = "", exponent] = text.split("e");
  const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  return (exponent === undefined ? short : `${short}e${exponent.replace("+", "")}`).replaceAll("-", MINUS);
}

/** Formats a probed value of an array with this range. Whole numbers keep all digits, because they may be ids. */
export function formatMeasured(value: number, range: Range | null): string {
  if (Number.isSafeInteger(value)) return value.toFixed(0).replaceAll("-", MINUS);
  const span = range === null ? 0 : range[1] - range[0];
  return formatNumber(value, span > 0 ? Math.min(span, Math.abs(value)) : undefined);
}

// Groups of three digits, separated by spaces (thin, no-break or plain) or commas.
const SPACED = /^[-+]?[1-9]\d{0,2}(?:[ \u00a0\u2009\u202f]\d{3})+(?![\d ])/;
const COMMAS = /^[-+]?[1-9]\d{0,2}(?:,\d{3})+(?=\.|$|e)/i;
const EITHER = /^[-+]?[1-9]\d{0,2},\d{3}(?=$|e)/i;

const withHyphen = (text: string): string => text.trim().replaceAll(MINUS, "-");

function withoutGroups(text: string): string {
  const spaced = text.replace(SPACED, (digits) => digits.replace(/\s/g, ""));
  return spaced.replace(COMMAS, (digits) => digits.replaceAll(",", "")).replace(",", ".");
}

/** Returns the finite number in the text, or null. Accepts the output of formatNumber and formatCount. */
export function parseNumber(text: string): number | null {
  const typed = withHyphen(text);
  if (typed === "" || EITHER.test(typed)) return null;
  const value = Number(withoutGroups(typed));
  return Number.isFinite(value) ? value : null;
}

/**
 * Returns a sentence that explains why parseNumber() returns null. One comma before three digits is ambiguous: the
 * comma may separate thousands or decimals.
 */
export function whyNoNumber(text: string): string {
  const typed = withHyphen(text);
  if (typed === "") return "The number is missing";
  if (!EITHER.test(typed)) return `"${text}" is not a number`;
  return `"${text}" can be read in two ways; write ${typed.replace(",", "")} or ${typed.replace(",", ".")}`;
}

export const formatCount = (count: number): string => count.toLocaleString("en-US").replaceAll(",", "\u202f");

export const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

/** Moves one end of a range to `to`. If `to` is beyond the other end, both ends become `to`. */
export const withEnd = ([low, high]: Range, end: 0 | 1, to: number): Range =>
  end === 0 ? [to, Math.max(to, high)] : [Math.min(to, low), to];

/** Returns the step to which a drag rounds values: the largest power of ten up to a thousandth of the range's width. */
export function niceStep([low, high]: Range): number {
  const span = high - low;
  return span > 0 ? 10 ** Math.floor(Math.log10(span / 1000)) : 1;
}

/**
 * Returns the ends and the step of a slider. The step is 1, 2 or 5 times a power of ten, at most 1/200 of the range.
 * The ends are multiples of the step, and may therefore lie outside the range.
 */
export function sliderTrack([low, high]: Range): { min: number; max: number; step: number } {
  const span = high - low;
  if (!(span > 0) || !Number.isFinite(span)) return { min: low, max: high, step: 1 };
  const power = 10 ** Math.floor(Math.log10(span / 200));
  const step = Number((([5, 2].find((n) => n * power <= span / 200) ?? 1) * power).toPrecision(1));
  const end = (round: (steps: number) => number, value: number): number =>
    Number((round(Number((value / step).toPrecision(12))) * step).toPrecision(12));
  return { min: end(Math.floor, low), max: end(Math.ceil, high), step };
}

const DECADES = 6;

/** Returns the lowest value on a logarithmic axis. Returns null if the range has negative values or no width. */
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

/** Returns the heights of histogram bars, from 0 to 1. Logarithmic heights keep the bars of rare values visible. */
export function barHeights(counts: readonly number[], logarithmic: boolean): number[] {
  const measure = (count: number): number => (logarithmic ? Math.log1p(count) : count);
  const top = measure(counts.reduce((most, count) => Math.max(most, count), 0));
  return counts.map((count) => (top > 0 ? measure(count) / top : 0));
}

/** Returns the middle of the widest gap between neighboring values, rounded. The ends of the range count as values. */
export function widestGap(values: readonly number[], [low, high]: Range): number {
  const stops = [low, ...values.filter((v) => v > low && v < high).sort((a, b) => a - b), high];
  let best = 0;
  for (let i = 1; i + 1 < stops.length; i += 1) {
    if ((stops[i + 1] ?? 0) - (stops[i] ?? 0) > (stops[best + 1] ?? 0) - (stops[best] ?? 0)) best = i;
  }
  return valueAt(fractionOf(((stops[best] ?? low) + (stops[best + 1] ?? high)) / 2, [low, high]), [low, high]);
}
