// Order of coincident batches among the layers of depth peeling. The order does not depend on the camera.
import type { GeometryBatch } from "../server/geometry";

export const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

type Described = Pick<GeometryBatch, "layer" | "lines" | "points" | "color" | "width">;

/**
 * Returns a number for each batch. Of coincident batches, the batch with the highest number is in front: points before
 * lines before surfaces, then by layer id. The scene's layer order has no effect.
 */
export function placesOf(batches: readonly Described[]): number[] {
  const keys = batches.map(({ layer, lines, points, color, width }) =>
    JSON.stringify([points ? 2 : lines ? 1 : 0, layer, lines || points ? [color, width] : []]),
  );
  const order = [...new Set(keys)].sort();
  return keys.map((key) => order.indexOf(key) + 1);
}
