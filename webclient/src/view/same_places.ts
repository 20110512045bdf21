// Order of batches whose geometry coincides. The order does not depend on the camera.
import type { GeometryBatch } from "../server/geometry";

export const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

type Described = Pick<GeometryBatch, "layer" | "lines" | "points" | "color" | "width">;

/**
 * Returns one number for each batch, from 1. Where batches coincide, the batch with the highest number is in front.
 * Points have higher numbers than lines, lines higher than surfaces; then the layer id decides. The scene's layer order
 * has no effect. All surfaces of one layer have the same number. Lines or points of one layer have the same number if
 * color and width are equal.
 */
export function placesOf(batches: readonly Described[]): number[] {
  const keys = batches.map(({ layer, lines, points, color, width }) =>
    JSON.stringify([points ? 2 : lines ? 1 : 0, layer, lines || points ? [color, width] : []]),
  );
  const order = [...new Set(keys)].sort();
  return keys.map((key) => order.indexOf(key) + 1);
}
