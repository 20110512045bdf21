import { describe, expect, test } from "vitest";
import cases from "../../tests/support/legend_cases.json";
import type { ArrayInfo, Layer } from "../src/generated/protocol";
import { legendsOf } from "../src/model/scalars";

describe("legends, as the server writes them", () => {
  for (const { what, layers, legends } of cases.cases)
    test(what, () => {
      const scene = { dataset: "box", layers: layers as unknown as Record<string, Layer> };
      const description = { arrays: [{ name: "U", scalars: ["U:magnitude"] } as ArrayInfo] };
      expect(legendsOf(scene, description).map(({ coloring, name }) => [coloring.array, name])).toEqual(legends);
    });
});
