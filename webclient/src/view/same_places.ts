// Fixed drawing order of coincident geometry, independent of the camera.
import type { GeometryBatch } from "../server/geometry";

export const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

type Described = Pick<GeometryBatch, "layer" | "lines" | "points" | "color" | "width">;

/**
 * Returns one place per batch, from 1; a higher place is nearer. Points are nearer than lines, lines nearer than
 * surfaces. Within a kind, layer names decide, so the layer order has no effect. Batches of one mesh share a place.
 */
export function placesOf(batches: readonly Described[]): number[] {
  const keys = batches.map(({ layer, lines, points, color, width }) =>
    JSON.stringify([points ? 2 : lines ? 1 : 0, layer, lines || points ? [color, width] : []]),
  );
  const order = [...new Set(keys)].sort();
  return keys.map((key) => order.indexOf(key) + 1);
}
