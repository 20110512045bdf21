import { describe, expect, test } from "vitest";
import table from "../../protocol/colormaps.json";
import cases from "../../tests/support/color_cases.json";
import { colorMapKinds, colorMapNames } from "../src/model/color_maps";
import {
  colorOf,
  colorRow,
  colorsAlong,
  hexOf,
  isShownBy,
  placeOf,
  scaleOf,
  scaleRules,
  valueAtPlace,
} from "../src/model/color_scale";
import type { Coloring, Range } from "../src/generated/protocol";
import { labelOn } from "../src/wasm/color_labels";

interface Case {
  name: string;
  coloring: Coloring;
  data: Range;
  range: Range;
  colors: [number | null, string][];
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
    expect(scaleRules(scale).texels.every(Number.isFinite)).toBe(true);
  });

  test("a range that is small beside its values keeps its digits in the shader", () => {
    const [low, high] = [101325 - 0.1, 101325 + 0.1];
    const { origin, texels } = scaleRules(scaleOf({ array: "p", range: [low, high] }, [0, 1]));
    const [start = NaN, factor = NaN, , , least = NaN, most = NaN] = texels;
    expect(Math.fround(origin)).toBe(origin);
    expect(origin + start).toBeCloseTo(low, 9);
    expect(origin + start + 1 / factor).toBeCloseTo(high, 7);
    expect(Math.abs(start)).toBeLessThan(0.01);
    expect(least).toBeLessThanOrEqual(start);
    expect(most).toBeLessThan(1);
    expect(scaleRules(scaleOf({ array: "p", range: [1, 10], log: true }, [0, 1])).origin).toBe(0);
  });

  test.each(cases.cases as unknown as Case[])("$name", ({ coloring, data, range, colors }) => {
    const scale = scaleOf(coloring, data);
    expect(scale.range.map(Math.fround)).toEqual(range.map(Math.fround));
    for (const [value, color] of colors) expect([value, hexOf(colorOf(scale, value ?? NaN))]).toEqual([value, color]);
  });

  test.each(cases.ends as unknown as [Coloring, string[]][])("%j is written as it was given", (coloring, labels) => {
    const scale = scaleOf(coloring, [0, 1]);
    expect(scale.range.map((end) => labelOn(scale, end))).toEqual(labels.slice(0, 2));
  });

  test("a row has a color for each step, or as many as are asked for", () => {
    expect(colorRow(scaleOf({ steps: 7 }, [0, 1]), 256)).toHaveLength(7);
    expect(colorRow(scaleOf({}, [0, 1]), 256)).toHaveLength(256);
  });

  test("places and values are inverse, and colors along a scale are the colors of its values", () => {
    for (const coloring of [{}, { log: true }, { log: true, symmetric: true }] as Coloring[]) {
      const scale = scaleOf({ ...coloring, array: "p", range: coloring.symmetric === true ? [-8, 8] : [2, 8] }, [0, 1]);
      const colors = colorsAlong(scale, 5);
      [0, 0.25, 0.5, 0.75, 1].forEach((place, i) => {
        expect(placeOf(scale, valueAtPlace(scale, place))).toBeCloseTo(place, 12);
        expect(colorOf(scale, valueAtPlace(scale, place))).toEqual(colors[i]);
      });
    }
  });

  test("a map that the page does not have is replaced by the default", () => {
    const [own, unknown] = ["viridis", "a map of tomorrow"].map((map) => colorRow(scaleOf({ map }, [0, 1]), 8));
    expect(unknown).toEqual(own);
  });

  test("the page has the maps of the table, in its order and by kind", () => {
    expect(colorMapNames()).toEqual(table.maps.map(({ name }) => name));
    expect(colorMapKinds().map(({ kind }) => kind)).toEqual(["sequential", "diverging", "cyclic"]);
    for (const { kind, names } of colorMapKinds())
      expect(names).toEqual(table.maps.filter((map) => map.kind === kind).map(({ name }) => name));
  });

  test("data without a logarithm are said not to be shown", () => {
    expect(isShownBy({ log: true }, [-1, 0])).toBe(false);
    expect(isShownBy({ log: true, range: [1, 2] }, [-1, 0])).toBe(true);
    expect(isShownBy({ log: true }, [-1, 1])).toBe(true);
    expect(isShownBy({}, [-1, 0])).toBe(true);
  });
});
