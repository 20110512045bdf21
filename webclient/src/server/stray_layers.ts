// Finds changes of layers that another client has removed.
import type { Layer, Scene } from "../generated/protocol";
import { isObject, type JsonObject } from "../model/merge_patch";

export function removedBetween(before: Scene | null, after: Scene): [string, Layer][] {
  return Object.entries(before?.layers ?? {}).filter(([id]) => !(id in (after.layers ?? {})));
}

/** Returns the ids of changed layers that the scene lacks. A change with a `type` adds a layer and is not returned. */
export function strayLayers({ layers }: JsonObject, scene: Scene): string[] {
  if (!isObject(layers)) return [];
  return Object.keys(layers).filter((id) => {
    const change = layers[id];
    return isObject(change) && !("type" in change) && !(id in (scene.layers ?? {}));
  });
}

export function withoutLayers(patch: JsonObject, ids: readonly string[]): JsonObject {
  if (ids.length === 0) return patch;
  const { layers, ...others } = patch;
  const kept = Object.entries(isObject(layers) ? layers : {}).filter(([id]) => !ids.includes(id));
  return kept.length === 0 ? others : { ...others, layers: Object.fromEntries(kept) };
}
