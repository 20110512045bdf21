import { expect, test } from "vitest";
import type { GeometryBatch } from "../src/server/geometry";
import { placesOf } from "../src/view/same_places";

type Described = Parameters<typeof placesOf>[0][number];

const black: GeometryBatch["color"] = [0, 0, 0, 1];
const surface = (layer: string, color = black): Described => ({ layer, lines: false, points: false, color, width: 1 });
const lines = (layer: string, width: number): Described => ({ ...surface(layer), lines: true, width });
const points = (layer: string): Described => ({ ...surface(layer), points: true });

test("points come before lines, and lines before surfaces", () => {
  expect(placesOf([lines("a", 1), points("b"), surface("c")])).toEqual([2, 3, 1]);
});

test("the order of the layers in the scene does not show", () => {
  expect(placesOf([surface("a"), surface("b")])).toEqual([1, 2]);
  expect(placesOf([surface("b"), surface("a")])).toEqual([2, 1]);
});

test("batches of one mesh are in one place, lines of two styles are not", () => {
  expect(placesOf([surface("a"), surface("a", [1, 0, 0, 1])])).toEqual([1, 1]);
  expect(placesOf([lines("a", 1), lines("a", 1), lines("a", 2)])).toEqual([1, 1, 2]);
});
