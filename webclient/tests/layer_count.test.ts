import { expect, test } from "vitest";
import { LayerCount, MOST_LAYERS, MOST_MOVING_LAYERS } from "../src/view/layer_count";

const layers = (filled: number, asked: number): boolean[] => Array.from({ length: asked }, (_, i) => i < filled);

test("a picture of more layers than were drawn is drawn again with twice as many, up to the most", () => {
  const count = new LayerCount();
  const drawn: number[] = [];
  do drawn.push(count.next(false));
  while (count.heard(layers(100, drawn.at(-1) ?? 0)));
  expect(drawn).toEqual([8, 16, MOST_LAYERS]);
});

test("after an empty layer so many are drawn as had something, and two for what a turn brings to light", () => {
  const count = new LayerCount();
  expect(count.heard(layers(3, count.next(false)))).toBe(false);
  expect(count.next(false)).toBe(5);
  expect(count.heard(layers(5, 5))).toBe(true);
  expect(count.next(false)).toBe(10);
});

test("what moves has fewer layers, and the still after it as many as there were", () => {
  const count = new LayerCount();
  count.heard(layers(20, 32));
  expect(count.next(true)).toBe(MOST_MOVING_LAYERS);
  expect(count.next(false)).toBe(22);
});
