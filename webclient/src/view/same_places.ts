// What lies in the same place must be seen in the same order wherever the camera is: each gets a place in that order.
import type { GeometryBatch } from "../server/geometry";

export const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

type Described = Pick<GeometryBatch, "layer" | "lines" | "points" | "color" | "width">;

/**
 * One for each batch, 1 and up: the higher, the nearer. Points come before lines and these before surfaces; among those
 * of a kind the layers' names decide, so that their order in the scene does not show. Batches of one mesh have the same.
 */
export function placesOf(batches: readonly Described[]): number[] {
  const keys = batches.map(({ layer, lines, points, color, width }) =>
    JSON.stringify([points ? 2 : lines ? 1 : 0, layer, lines || points ? [color, width] : []]),
  );
  const order = [...new Set(keys)].sort();
  return keys.map((key) => order.indexOf(key) + 1);
}
