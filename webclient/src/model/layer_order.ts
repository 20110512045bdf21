// Order of layers in the list, the legends and the drawing. Where layers coincide, the last one is visible.
import type { Layer, Scene } from "../generated/protocol";
import type { JsonObject } from "./merge_patch";

type Entry = [string, Layer];

/** A scene, or the part of it that has the layers. */
export type Layered = Pick<Scene, "layers">;

/** Layers in the order in which the server draws them: by `order`, then by id. */
export const layersInOrder = (scene: Layered | null): Entry[] =>
  Object.entries(scene?.layers ?? {}).sort(
    ([a, x], [b, y]) => (x.order ?? 0) - (y.order ?? 0) || (a < b ? -1 : a > b ? 1 : 0),
  );

/** Returns the patch of `layers` that moves a layer to `place`, its index in the resulting order. null: no change. */
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
