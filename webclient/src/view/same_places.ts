// Order of batches whose geometry coincides. It does not depend on the camera.
import type { GeometryBatch } from "../server/geometry";

export const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

type Described = Pick<GeometryBatch, "layer" | "lines" | "points" | "color" | "width">;

/**
 * Returns one place for each batch, from 1. Where batches coincide, the one with the higher place is drawn in front:
 * points before lines, lines before surfaces, then by layer id. The scene's layer order has no effect. Lines or points
 * of one layer share a place if color and width are equal; surfaces of one layer always do.
 */
export function placesOf(batches: readonly Described[]): number[] {
  const keys = batches.map(({ layer, lines, points, color, width }) =>
    JSON.stringify([points ? 2 : lines ? 1 : 0, layer, lines || points ? [color, width] : []]),
  );
  const order = [...new Set(keys)].sort();
  return keys.map((key) => order.indexOf(key) + 1);
}
