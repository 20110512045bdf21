// Names of layers that distinguish several legends of one array. Same rules as server/geometry/legend_names.hpp. The
// cases in tests/support/legend_cases.json test both files.
import type { Layer, SliceLayer } from "../generated/protocol";
import { numberAlone, timesPowerOfTen } from "../wasm/numbers_as_text";

const MOST_LISTED = 2;

export function listed(words: readonly string[]): string {
  const more = words.length - MOST_LISTED;
  return words.slice(0, MOST_LISTED).join(", ") + (more > 0 ? ` and ${more} more` : "");
}

function nameOfSlice({ axis, value, origin, normal }: SliceLayer): string {
  if (axis !== undefined) return `Slice at ${axis} = ${numberAlone(value ?? 0)}`;
  const along = [0, 1, 2].filter((at) => normal?.[at] !== 0);
  const [only] = along;
  if (along.length !== 1 || only === undefined) return "Free plane";
  return `Slice at ${"xyz".charAt(only)} = ${numberAlone(origin?.[only] ?? 0)}`;
}

export function legendNameOf(layer: Layer, part: "layers" | "contours"): string {
  switch (layer.type) {
    case "iso":
      return `Iso-surface of ${layer.array}`;
    case "slice":
      return part === "contours" ? `Lines on ${nameOfSlice(layer).toLowerCase()}` : nameOfSlice(layer);
    case "surface":
      return (layer.groups ?? []).length === 0 ? "Boundary" : `Boundary: ${listed(layer.groups ?? [])}`;
    case "edges":
      return "Edges";
    case "points":
      return "Points";
    case "volume":
      return "Volume";
    case "outline":
    case "clip":
      return "";
  }
}

/** Title of a legend on one line, with units in brackets, as in server/annotations/legend_layout.cpp. */
export function legendTitle(array: string, units: string, exponent: number): string {
  return array + (units === "" ? "" : ` [${units}]`) + timesPowerOfTen(exponent);
}

export interface NamedLegend {
  array: string;
  /** Names of the layers that use the legend, from legendNameOf. */
  names: readonly string[];
}

/** A name is empty if no other legend has the same array. */
export function legendNames(legends: readonly NamedLegend[]): string[] {
  const taken = new Map<string, number>();
  return legends.map(({ array, names }, index) => {
    if (!legends.some((other, at) => at !== index && other.array === array)) return "";
    const name = listed([...new Set(names)]);
    const key = JSON.stringify([array, name]);
    const count = (taken.get(key) ?? 0) + 1;
    taken.set(key, count);
    return count === 1 ? name : `${name} (${count})`;
  });
}
