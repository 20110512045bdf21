// Order of layers in the list, the legends and the drawing. Of coincident opaque surfaces, the last layer is visible.
import type { Layer, Scene } from "../generated/protocol";
import type { JsonObject } from "./merge_patch";

type Entry = [string, Layer];

export type Layered = Pick<Scene, "layers">;

export const layersInOrder = (scene: Layered | null): Entry[] =>
  Object.entries(scene?.layers ?? {}).sort(
    ([a, x], [b, y]) => (x.order ?? 0) - (y.order ?? 0) || (a < b ? -1 : a > b ? 1 : 0),
  );

/** Returns the merge patch of `layers` that moves a layer to index `place`; null if the order stays the same. */
export function movedTo(scene: Scene, id: string, place: number): JsonObject | null {
  const before = layersInOrder(scene);
  const moved = before.find(([other]) => other === id);
  if (moved === undefined) return null;
  const after = before.filter(([other]) => other !== id);
  after.splice(Math.max(0, place), 0, moved);
  if (after.every(([other], index) => other === before[index]?.[0])) return null;
  const changed = after.flatMap(([other, layer], order) =>
    layer.order === order ? [] : [[other, { order }] as const],
  );
  return Object.fromEntries(changed);
}
