import { describe, expect, test } from "vitest";
import { PolygonBytes } from "../src/server/polygon_bytes";

describe("bytes of polygons", () => {
  test("are 8 a triangle before any have come", () => {
    const polygons = new PolygonBytes();
    expect(polygons.all(1000)).toBe(8000);
    expect(polygons.change(1000)).toBe(8000);
    expect(polygons.triangles).toBe(0);
  });

  test("of everything are not those of a frame that held a change", () => {
    const polygons = new PolygonBytes();
    polygons.presented(300_000, 60_000);
    polygons.presented(400, 60_000); // only the colors have changed
    expect(polygons.all(60_000)).toBe(300_000);
    expect(polygons.change(60_000)).toBe(400);
    expect(polygons.triangles).toBe(60_000);
  });

  test("of a frame without triangles say nothing", () => {
    const polygons = new PolygonBytes();
    polygons.presented(300, 0);
    expect(polygons.all(100)).toBe(800);
    expect(polygons.change(100)).toBe(800);
  });

  test("of another dataset are forgotten", () => {
    const polygons = new PolygonBytes();
    polygons.presented(300_000, 60_000);
    polygons.forget();
    expect(polygons.all(1000)).toBe(8000);
  });
});
