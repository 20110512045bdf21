import { describe, expect, test } from "vitest";
import cases from "../../tests/support/tick_cases.json";
import { labelOn } from "../src/wasm/color_labels";
import { scaleOf } from "../src/model/color_scale";
import { legendTitle } from "../src/wasm/legend_names";
import { numberAlone } from "../src/wasm/numbers_as_text";

describe("numbers, as the server writes them", () => {
  test.each(cases.alone as [number | null, string][])("%d alone: %s", (value, label) =>
    expect(numberAlone(value ?? NaN)).toBe(label),
  );
  test.each(cases.rounded as [number, number, string][])("%d with %d digits: %s", (value, digits, label) =>
    expect(numberAlone(value, digits)).toBe(label),
  );
  test("a scale takes a common power of ten out of them unless it is logarithmic", () => {
    const scale = scaleOf({ range: [1.2e-5, 3.4e-5] }, [0, 1]);
    expect([legendTitle("p", "Pa", scale), labelOn(scale, 2.5e-5)]).toEqual(["p [Pa] \u00d710\u207b\u2075", "2.5"]);
    const logarithmic = { ...scale, log: true };
    expect([legendTitle("p", "", logarithmic), labelOn(logarithmic, 2.5e-5), labelOn(logarithmic, 1e-5)]).toEqual([
      "p",
      "2.5 \u00d710\u207b\u2075",
      "10\u207b\u2075",
    ]);
    const wide = { ...logarithmic, range: [4.39584e-6, 4.39584] as [number, number] };
    expect([labelOn(wide, 4.39584), labelOn(wide, 0.001)]).toEqual(["4.4", "0.001"]);
  });
});
