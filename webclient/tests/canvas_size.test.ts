import { expect, test } from "vitest";
import { CanvasSize } from "../src/model/canvas_size";
import { makeModel } from "../src/model/model";

test("the size of the canvas is the model's, in device pixels by the ratio of the screen", () => {
  const model = makeModel({ canvasSize: { width: 300, height: 200 } });
  const size = new CanvasSize(model.canvasSize);
  expect([size.css, size.aspect]).toEqual([{ width: 300, height: 200 }, 1.5]);
  size.set(400, 100, 2);
  expect(model.canvasSize.value).toEqual({ width: 400, height: 100 });
  expect([size.css, size.pixels(), size.pixelRatio]).toEqual([
    { width: 400, height: 100 },
    { width: 800, height: 200 },
    2,
  ]);
});
