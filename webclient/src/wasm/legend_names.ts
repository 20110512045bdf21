// Titles and names of legends, computed by the code of server/annotations/legend_names.hpp.
import type { Layer, SliceLayer, Vec3 } from "../generated/protocol";
import { valuesItem, type ScaleOfValues } from "./color_scale";
import { call } from "./layout_module";
import type { Item } from "./message";

const ZERO: Vec3 = [0, 0, 0];
const ACROSS: Record<"x" | "y" | "z", Vec3> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** Returns a point and the normal of the plane. */
function planeOf({ axis, value = 0, origin = ZERO, normal = ZERO }: SliceLayer): readonly [Vec3, Vec3] {
  return axis === undefined ? [origin, normal] : [[value, value, value], ACROSS[axis]];
}

const listed = (texts: readonly string[]): Item => [texts.length, texts];

/** Returns a short name that fits above a color bar. `part`: the layer itself, or the contour lines on the layer. */
export function legendNameOf(layer: Layer, part: "layers" | "contours"): string {
  const array = layer.type === "iso" ? layer.array : "";
  const plane = layer.type === "slice" ? planeOf(layer) : [ZERO, ZERO];
  const groups = (layer.type === "surface" && layer.groups) || [];
  return call("legend_name_of", layer.type, part === "contours", array, plane, listed(groups)).text();
}

/** Returns one line: array, units in brackets, and the power of ten that is factored out of the scale's numbers. */
export const legendTitle = (array: string, units: string, scale: ScaleOfValues): string =>
  call("legend_title", valuesItem(scale), array, units).text();

export interface NamedLegend {
  array: string;
  /** Names of the layers that use the legend, from legendNameOf. */
  names: readonly string[];
}

/** Returns one name per legend. A name is empty if no other legend has the same array. */
export function legendNames(legends: readonly NamedLegend[]): string[] {
  const items = legends.map(({ array, names }): Item => [array, listed(names)]);
  const results = call("legend_names", legends.length, items);
  return results.list(() => results.text());
}
