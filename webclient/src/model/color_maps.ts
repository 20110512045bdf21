// Names of the page's color maps. Their colors are in the WebAssembly module.
import { DEFAULTS } from "../generated/protocol";
import table from "../../../protocol/colormaps.json";

const first = table.maps[0]?.name ?? "viridis";

export const colorMapNames: readonly string[] = table.maps.map(({ name }) => name);

/** Returns `name`, or the name of the first map if the page does not have this map. A newer server may have it. */
export const knownMap = (name: string): string => (colorMapNames.includes(name) ? name : first);

export const DEFAULT_MAP = DEFAULTS.Coloring.map;
/** Default color of missing values, as #rrggbb. */
export const missingHex = `#${table.nan}`;

export const colorMapKinds: readonly { kind: string; names: string[] }[] = [
  ...new Set(table.maps.map(({ kind }) => kind)),
].map((kind) => ({ kind, names: table.maps.filter((map) => map.kind === kind).map(({ name }) => name) }));
