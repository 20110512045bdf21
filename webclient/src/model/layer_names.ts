// Names of layers for display.
import type { Layer, Vec3 } from "../generated/protocol";
import { layersInOrder, type Layered } from "./layer_order";
import { formatNumber } from "./numbers";

const MOST_LISTED = 3;

function list(words: readonly string[]): string {
  const more = words.length - MOST_LISTED;
  return words.slice(0, MOST_LISTED).join(", ") + (more > 0 ? ` and ${more} more` : "");
}

const numbers = (values: readonly number[]): string[] => values.map((value) => formatNumber(value));

function plane(origin: Vec3 | undefined, normal: Vec3 | undefined): string {
  return `Plane through (${numbers(origin ?? []).join(", ")}), normal (${numbers(normal ?? []).join(", ")})`;
}

export function layerName(layer: Layer): string {
  switch (layer.type) {
    case "iso":
      return `Iso-surface of ${layer.array} at ${layer.values.length === 0 ? "no value" : list(numbers(layer.values))}`;
    case "slice":
      return layer.axis === undefined
        ? plane(layer.origin, layer.normal)
        : `Slice at ${layer.axis} = ${formatNumber(layer.value ?? 0)}`;
    case "surface":
      return (layer.groups ?? []).length === 0 ? "Whole boundary" : `Boundary: ${list(layer.groups ?? [])}`;
    case "edges":
      return layer.angle === undefined ? "Edges of the boundary" : `Edges that bend by ${formatNumber(layer.angle)}°`;
    case "points":
      return layer.of === "all" ? "All points" : "Points of the boundary";
    case "clip":
      return layer.axis === undefined
        ? `Clip: ${plane(layer.origin, layer.normal)}`
        : `Clip at ${layer.axis} = ${formatNumber(layer.value ?? 0)}`;
    case "outline":
      return "Outline";
    case "volume":
      return `Volume of ${layer.array}`;
  }
}

/** Returns the display names by layer id, in layer order. Layers with equal names get numbers, as in "Slice (2)". */
export function layerNames(scene: Layered | null): Map<string, string> {
  const seen = new Map<string, number>();
  return new Map(
    layersInOrder(scene).map(([id, layer]) => {
      const name = layerName(layer);
      const count = (seen.get(name) ?? 0) + 1;
      seen.set(name, count);
      return [id, count === 1 ? name : `${name} (${count})`];
    }),
  );
}
