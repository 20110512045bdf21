import { describe, expect, test } from "vitest";
import cases from "../../tests/support/tick_cases.json";
import { colorTicks, exponentOf, labelOn } from "../src/wasm/color_ticks";
import { scaleOf } from "../src/model/color_range";
import { numberAlone, timesPowerOfTen } from "../src/wasm/numbers_as_text";

describe("marks of a linear scale, as the server has them", () => {
  // The contract refuses a range whose ends are exchanged; the server's tests have that case.
  const scales = (cases.scales as [number, number, number, string][]).filter(([low, high]) => low <= high);
  test.each(scales)("%d to %d, at most %d: %s", (low, high, most, labels) => {
    const scale = scaleOf({ range: [low, high] }, [0, 1]);
    const found = colorTicks(scale, most).map(({ label }) => label);
    expect(found.join(" ") + timesPowerOfTen(exponentOf(scale))).toBe(labels);
  });

  test("are even, inside, and say their value", () => {
    for (let round = 0; round < 5000; round += 1) {
      const low = (Math.random() * 20 - 10) * 10 ** Math.floor(Math.random() * 60 - 30);
      const span = Math.max(Math.abs(low), 1e-30) * 10 ** (Math.random() * 7 - 6);
      const most = 1 + (round % 10);
      const scale = scaleOf({ range: [low, low + span] }, [0, 1]);
      const ticks = colorTicks(scale, most);
      const exponent = exponentOf(scale);
      expect(ticks.length).toBeLessThanOrEqual(most);
      if (most >= 3) expect(ticks.length, `${low} ${span} ${most}`).toBeGreaterThanOrEqual(1);
      for (const { value, label } of ticks) {
        expect(value).toBeGreaterThanOrEqual(low - 1e-8 * span);
        expect(value).toBeLessThanOrEqual(low + span * (1 + 1e-8));
        const said = Number(label.replace("\u2212", "-")) * 10 ** exponent;
        expect(Math.abs(said - value), label).toBeLessThanOrEqual(1e-3 * span);
      }
    }
  });
});

describe("marks of steps, as the server has them", () => {
  test.each(cases.marks as [number, number, number, number, number][])(
    "%d steps, at most %d marks: one every %d, a label every %d",
    (steps, most, marks, labels, count) => {
      for (const log of [false, true]) {
        const found = colorTicks(scaleOf({ steps, log, range: [1, 1e4] }, [0, 1]), 6, most);
        expect(found).toHaveLength(count);
        found.forEach(({ at, label }, i) => {
          expect(at).toBeCloseTo((i * marks) / steps, 9);
          expect(label === "").toBe((i * marks) % labels !== 0);
        });
      }
    },
  );
});

describe("numbers, as the server writes them", () => {
  test.each(cases.alone as [number | null, string][])("%d alone: %s", (value, label) =>
    expect(numberAlone(value ?? NaN)).toBe(label),
  );
  test.each(cases.rounded as [number, number, string][])("%d with %d digits: %s", (value, digits, label) =>
    expect(numberAlone(value, digits)).toBe(label),
  );
  test("no label of a logarithmic scale has ten before its power", () => {
    for (const decades of [1, 6, 12])
      for (let low = -30; low <= 20; low += 1)
        for (const steps of [0, 5, 6, 10, 12]) {
          const range: [number, number] = [Number(`1e${low}`), Number(`1e${low + decades}`)];
          const scale = scaleOf({ range, log: true, steps }, [0, 1]);
          const labels = [...colorTicks(scale).map(({ label }) => label), labelOn(scale, scale.range[1])];
          expect(labels.filter((label) => label.startsWith("10 \u00d7"))).toEqual([]);
        }
  });
  test("a scale takes a common power of ten out of them unless it is logarithmic", () => {
    const scale = scaleOf({ range: [1.2e-5, 3.4e-5] }, [0, 1]);
    expect([exponentOf(scale), labelOn(scale, 2.5e-5)]).toEqual([-5, "2.5"]);
    const logarithmic = { ...scale, log: true };
    expect([exponentOf(logarithmic), labelOn(logarithmic, 2.5e-5), labelOn(logarithmic, 1e-5)]).toEqual([
      0,
      "2.5 \u00d710\u207b\u2075",
      "10\u207b\u2075",
    ]);
    const wide = { ...logarithmic, range: [4.39584e-6, 4.39584] as [number, number] };
    expect([labelOn(wide, 4.39584), labelOn(wide, 0.001)]).toEqual(["4.4", "0.001"]);
  });
});
