import { describe, expect, test } from "vitest";
import { keyed } from "../src/panels/controls/histogram_slider";
import {
  barHeights,
  formatCount,
  formatMeasured,
  formatNumber,
  fractionOf,
  logarithmicStart,
  niceStep,
  parseNumber,
  sliderTrack,
  valueAt,
  whyNoNumber,
  widestGap,
} from "../src/model/numbers";

describe("writing numbers", () => {
  test.each([
    [0, 1, "0"],
    [0.12345678, 1, "0.123"],
    [0.5, 1, "0.5"],
    [101325.123, 10, "101325.12"],
    [101325.123, 100000, "101325"],
    [-2.5, 5, "\u22122.5"],
    [1.5e-9, 1e-8, "1.5e\u22129"],
    [2.5e12, 1e12, "2.5e12"],
    [123456, 1e6, "123456"],
    [NaN, 1, "n/a"],
    [7, 0, "7"],
    [1234567, 0, "1.235e6"],
    [123456, 0, "123456"],
    [0.00001234, 0, "1.234e\u22125"],
    [0.1, 10, "0.1"],
    [101325, 20, "101325"],
    [101325.5, 1, "101325.5"],
    [-0.25, 1, "\u22120.25"],
    [1e-7, 1e-7, "1e\u22127"],
    [2e9, 0, "2e9"],
  ])("%d within a span of %d is %s", (value, span, text) => {
    expect(formatNumber(value, span)).toBe(text);
  });

  test.each([
    [101325.0042, [101324.99, 101325.01] as [number, number], "101325.0042"],
    [101325.0042, null, "101325"],
    [-16777217, [0, 2 ** 30] as [number, number], "\u221216777217"],
    [0.123456, [0, 1000] as [number, number], "0.1235"],
    [4000000.25, [4000000, 4000001] as [number, number], "4.00000025e6"],
  ])("%d, measured in %j, is %s", (value, range, text) => {
    expect(formatMeasured(value, range)).toBe(text);
  });

  test("what is written can be typed", () => {
    for (const value of [0, -1.25, 1.5e-9, 2.5e12, 101325]) expect(parseNumber(formatNumber(value))).toBe(value);
    expect(parseNumber("0,5")).toBe(0.5);
    expect(parseNumber(" 3 ")).toBe(3);
    for (const wrong of ["", "a", "1 2", "1e999", "--1"]) expect(parseNumber(wrong)).toBeNull();
    for (const count of [0, 999, 1000, 37479, 1234567]) expect(parseNumber(formatCount(count))).toBe(count);
  });

  test.each([
    ["1,5", 1.5],
    ["1,50", 1.5],
    ["0,125", 0.125],
    ["1234,567", 1234.567],
    ["1,2345", 1.2345],
    ["37 479", 37479],
    ["37\u00a0479", 37479],
    ["37\u202f479", 37479],
    ["37\u2009479,5", 37479.5],
    ["\u22121 234 567.25", -1234567.25],
    ["1 500,250", 1500.25],
    ["1,234,567", 1234567],
    ["1,500.0", 1500],
    ["-1,234.5e3", -1234500],
  ])("%s is %d", (text, value) => expect(parseNumber(text)).toBe(value));

  test.each(["1,500", "37,479", "-1,500", "1,500e3", "12 34", "1 2345", "0 123", "1 500 2", "1.234,5", "1,5,5"])(
    "%s is refused",
    (text) => expect(parseNumber(text)).toBeNull(),
  );

  test("a comma that may part thousands is asked about", () => {
    expect(whyNoNumber("1,500")).toBe('"1,500" can be read in two ways; write 1500 or 1.500');
    expect(whyNoNumber("\u22121,500")).toContain("write -1500 or -1.500");
    expect(whyNoNumber("x")).toBe('"x" is not a number');
  });
});

describe("slider over a histogram", () => {
  const range: [number, number] = [-0.37, 1.94];
  test("both ways, to the ends exactly", () => {
    expect(valueAt(0, range)).toBe(range[0]);
    expect(valueAt(1, range)).toBe(range[1]);
    expect(valueAt(-3, range)).toBe(range[0]);
    for (let f = 0; f <= 1; f += 0.01) {
      expect(fractionOf(valueAt(f, range), range)).toBeCloseTo(f, 2);
    }
  });

  test("a drag gives values one can say", () => {
    expect(valueAt(0.5, [0, 1])).toBe(0.5);
    expect(String(valueAt(1 / 3, [0, 1])).length).toBeLessThanOrEqual(5);
    expect(niceStep([0, 1])).toBeCloseTo(0.001, 12);
  });

  test("a range without extent breaks nothing", () => {
    expect(fractionOf(3, [3, 3])).toBe(0.5);
    expect(valueAt(0.5, [3, 3])).toBe(3);
  });

  test("bars: linear and logarithmic", () => {
    expect(barHeights([0, 5, 10], false)).toEqual([0, 0.5, 1]);
    const [none, rare, most] = barHeights([0, 1, 1e6], true);
    expect([none, most]).toEqual([0, 1]);
    expect(rare).toBeGreaterThan(0.04);
    expect(barHeights([0, 0], true)).toEqual([0, 0]);
  });

  test("keys", () => {
    expect(keyed("ArrowRight", false, 0.5, [0, 1])).toBe(0.51);
    expect(keyed("ArrowLeft", true, 0.5, [0, 1])).toBe(0.4);
    expect(keyed("PageUp", false, 0.5, [0, 1])).toBe(0.6);
    expect(keyed("Home", false, 0.5, [0, 1])).toBe(0);
    expect(keyed("End", false, 0.5, [0, 1])).toBe(1);
    expect(keyed("ArrowUp", true, 0.99, [0, 1])).toBe(1);
    expect(keyed("a", false, 0.5, [0, 1])).toBeNull();
  });

  test("a logarithmic axis: both ways, the same factor everywhere", () => {
    const wide: [number, number] = [1e-4, 100];
    expect([0, 0.5, 1].map((f) => valueAt(f, wide, true))).toEqual([1e-4, 0.1, 100]);
    for (const f of [0.1, 0.35, 0.8]) expect(fractionOf(valueAt(f, wide, true), wide, true)).toBeCloseTo(f, 2);
    const keys = [1e-3, 1].map((value) => (keyed("PageUp", false, value, wide, true) ?? 0) / value);
    expect(keys[0]).toBeCloseTo(keys[1] ?? 0, 1);
    expect(keyed("ArrowRight", false, 1, wide, true)).toBeGreaterThan(1.1);
    expect(keyed("Home", false, 1, wide, true)).toBe(1e-4);
  });

  test("a logarithmic axis from zero ends at zero; below zero there is none", () => {
    expect(valueAt(0, [0, 1], true)).toBe(0);
    expect(valueAt(1e-9, [0, 1], true)).toBeCloseTo(1e-6, 9);
    expect(fractionOf(0, [0, 1], true)).toBe(0);
    for (const range of [
      [-1, 1],
      [0, 0],
      [3, 3],
    ] as [number, number][]) {
      expect(logarithmicStart(range)).toBeNull();
      expect(valueAt(0.5, range, true)).toBe(valueAt(0.5, range));
    }
  });

  test("one more value goes into the widest gap", () => {
    expect(widestGap([], [0, 1])).toBe(0.5);
    expect(widestGap([0.5], [0, 1])).toBe(0.25);
    expect(widestGap([0.2, 0.4], [0, 1])).toBe(0.7);
  });

  test.each([
    [-0.8372, 1.2914],
    [-7.81575, 14.3622],
    [0, 8.32756],
    [1e5 + 0.37, 1e5 + 3.1],
    [-2.1e-7, 5.3e-7],
    [-1, 1],
  ] as [number, number][])("a slider from %d to %d steps by round numbers and reaches both ends", (low, high) => {
    const { min, max, step } = sliderTrack([low, high]);
    expect(step.toExponential()).toMatch(/^[125]e/);
    expect(step).toBeLessThanOrEqual((high - low) / 200);
    expect(step).toBeGreaterThan((high - low) / 520);
    for (const end of [min, max]) expect(Math.abs(end / step - Math.round(end / step))).toBeLessThan(1e-6);
    expect(min <= low && low - min < step).toBe(true);
    expect(max >= high && max - high < step).toBe(true);
  });

  test("a slider over nothing stands still", () => {
    expect(sliderTrack([3, 3])).toEqual({ min: 3, max: 3, step: 1 });
  });
});
