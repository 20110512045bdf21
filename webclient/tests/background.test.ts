import { expect, test } from "vitest";
import "./layout_module";
import { backgroundColors, isBright } from "../src/model/background";

test("a named background is a gradient, a color is the same everywhere", () => {
  const { top, bottom } = backgroundColors("light");
  expect(top).toEqual([1, 1, 1]);
  expect(bottom[2]).toBeCloseTo(0.95);
  expect(backgroundColors("#ff0033")).toEqual({ top: [1, 0, 0.2], bottom: [1, 0, 0.2] });
});

test("the background is dark if a scene has none", () => {
  expect(backgroundColors(undefined)).toEqual(backgroundColors("dark"));
  expect(isBright(undefined)).toBe(false);
});

test("text on a bright background is dark", () => {
  expect(isBright("light")).toBe(true);
  expect(isBright("#00ff00")).toBe(true);
  expect(isBright("#0000ff")).toBe(false);
});
