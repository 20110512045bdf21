import { expect, test } from "vitest";
import { lightsOf } from "../src/model/lights";

test("a scene without lighting has all lights at their full strength", () => {
  expect(lightsOf(undefined)).toEqual({ on: true, strengths: [1, 1, 1] });
  expect(lightsOf({})).toEqual({ on: true, strengths: [1, 1, 1] });
});

test("strengths and switches", () => {
  expect(lightsOf({ ambient: 0.5, headlight: { strength: 2 }, key_light: { strength: 0.25 } }).strengths).toEqual([
    0.5, 2, 0.25,
  ]);
  expect(lightsOf({ headlight: { on: false, strength: 2 }, key_light: { on: true } }).strengths).toEqual([1, 0, 1]);
  expect(lightsOf({ on: false }).on).toBe(false);
});
