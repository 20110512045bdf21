import { describe, expect, test } from "vitest";
import cases from "../../tests/support/color_cases.json";
import { colorOf, colorRow, hexOf } from "../src/model/color_scale";
import type { Coloring, Range } from "../src/generated/protocol";
import { scaleRules } from "../src/view/scale_textures";
import { isShownBy, scaleOf } from "../src/model/color_range";
import { colorTicks, labelOn } from "../src/wasm/color_ticks";

interface Case {
  name: string;
  coloring: Coloring;
  data: Range;
  range: Range;
  colors: [number | null, string][];
  ticks?: [number, number, string][];
}

describe("the color scale", () => {
  test.each([
    [-1e308, 1e308],
    [-3.4e38, 3.4e38],
    [0, 1e308],
    [1e-42, 3e-42],
    [5e-324, 1e-320],
    [1e9, 1e9 + 1e-3],
    [5, 5],
  ] as Range[])("from %d to %d has ends that are written, and a finite width", (low, high) => {
    const scale = scaleOf({ array: "p", range: [low, high] }, [0, 1]);
    expect(scale.range.every(Number.isFinite)).toBe(true);
    for (const end of scale.range) {
      expect(labelOn(scale, end)).not.toBe("n/a");
      expect(labelOn(scale, end).length).toBeLessThan(15);
    }
    const ticks = colorTicks(scale);
    expect(ticks.length).toBeGreaterThan(0);
    for (const { at } of ticks) expect(at >= 0 && at <= 1).toBe(true);
    expect(scaleRules(scale).rule.map(Math.fround).every(Number.isFinite)).toBe(true);
  });

  test("a range that is small beside its values keeps its digits in the shader", () => {
    const [low, high] = [101325 - 0.1, 101325 + 0.1];
    const { origin, rule, inside } = scaleRules(scaleOf({ array: "p", range: [low, high] }, [0, 1]));
    expect(Math.fround(origin)).toBe(origin);
    expect(origin + rule[0]).toBeCloseTo(low, 9);
    expect(rule[0] + 1 / rule[1] + origin).toBeCloseTo(high, 9);
    expect(Math.abs(rule[0])).toBeLessThan(0.01);
    expect(inside[0]).toBeLessThanOrEqual(rule[0]);
    expect(inside[1]).toBeLessThan(1);
    expect(scaleRules(scaleOf({ array: "p", range: [1, 10], log: true }, [0, 1])).origin).toBe(0);
  });

  test.each(cases.cases as unknown as Case[])("$name", ({ coloring, data, range, colors, ticks }) => {
    const scale = scaleOf(coloring, data);
    expect(scale.range.map(Math.fround)).toEqual(range.map(Math.fround));
    for (const [value, color] of colors) expect([value, hexOf(colorOf(scale, value ?? NaN))]).toEqual([value, color]);
    if (ticks === undefined) return;
    const found = colorTicks(scale);
    expect(found.map(({ label }) => label)).toEqual(ticks.map(([, , label]) => label));
    found.forEach(({ value, at }, i) => {
      expect(value).toBeCloseTo(ticks[i]?.[0] ?? NaN, 6);
      expect(at).toBeCloseTo(ticks[i]?.[1] ?? NaN, 6);
    });
  });

  test.each(cases.ends as unknown as [Coloring, string[]][])("%j is written as it was given", (coloring, labels) => {
    const scale = scaleOf(coloring, [0, 1]);
    const ends = scale.range.map((end) => labelOn(scale, end));
    expect([...ends, ...colorTicks(scale).map(({ label }) => label)]).toEqual(labels);
  });

  test("a row has a color for each step, or as many as are asked for", () => {
    expect(colorRow(scaleOf({ steps: 7 }, [0, 1]), 256)).toHaveLength(7);
    expect(colorRow(scaleOf({}, [0, 1]), 256)).toHaveLength(256);
  });

  test("ticks of any range are few, in order and inside", () => {
    for (const log of [false, true])
      for (const steps of [null, 2, 7, 256])
        for (const range of [
          [1, 1.0000001],
          [1e-30, 1e30],
          [1e-37, 1],
          [3, 3e12],
        ] as Range[]) {
          const found = colorTicks(scaleOf({ log, steps, range }, [0, 1]));
          expect(found.length).toBeGreaterThan(0);
          expect(found.length).toBeLessThan(300);
          const labels = found.filter(({ label }) => label !== "").length;
          expect(labels).toBeGreaterThan(0);
          expect(labels).toBeLessThan(15);
          const places = found.map(({ at }) => at);
          expect(places).toEqual([...places].sort((a, b) => a - b));
        }
  });

  test("data without a logarithm are said not to be shown", () => {
    expect(isShownBy({ log: true }, [-1, 0])).toBe(false);
    expect(isShownBy({ log: true, range: [1, 2] }, [-1, 0])).toBe(true);
    expect(isShownBy({ log: true }, [-1, 1])).toBe(true);
    expect(isShownBy({}, [-1, 0])).toBe(true);
  });
});
