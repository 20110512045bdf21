// The order of layers: of the list, of the legends, and of what is drawn over what lies in the same place.
import type { Layer, Scene } from "../generated/protocol";
import type { JsonObject } from "./merge_patch";

type Entry = [string, Layer];

/** As the server draws them: by order, then by id. */
export const layersInOrder = (scene: Scene | null): Entry[] =>
  Object.entries(scene?.layers ?? {}).sort(
    ([a, x], [b, y]) => (x.order ?? 0) - (y.order ?? 0) || (a < b ? -1 : a > b ? 1 : 0),
  );

/** The patch of `layers` that brings one to a place among all, which is counted without it; null where it stands there. */
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
