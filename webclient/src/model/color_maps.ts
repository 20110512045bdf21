// Color maps of the page, decoded from protocol/colormaps.json. The server decodes the same table.
import { DEFAULTS } from "../generated/protocol";
import table from "../../../protocol/colormaps.json";

// 256 RGBA entries
export type Colors = Uint8Array<ArrayBuffer>;

function decode(hex: string): Colors {
  const rgba = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; i += 1) {
    for (let channel = 0; channel < 3; channel += 1) {
      rgba[4 * i + channel] = parseInt(hex.slice(6 * i + 2 * channel, 6 * i + 2 * channel + 2), 16);
    }
    rgba[4 * i + 3] = 255;
  }
  return rgba;
}

const maps = new Map(table.maps.map(({ name, colors }) => [name, decode(colors)]));
const first = table.maps[0]?.name ?? "viridis";

/** Returns `name`, or the name of the first map if the page does not have this map. A newer server may have it. */
export const knownMap = (name: string): string => (maps.has(name) ? name : first);

export const colorMapNames: readonly string[] = table.maps.map(({ name }) => name);
export const DEFAULT_MAP = DEFAULTS.Coloring.map;
/** Default color of missing values, as #rrggbb. */
export const missingHex = `#${table.nan}`;

export const colorMapKinds: readonly { kind: string; names: string[] }[] = [
  ...new Set(table.maps.map(({ kind }) => kind)),
].map((kind) => ({ kind, names: table.maps.filter((map) => map.kind === kind).map(({ name }) => name) }));

export function colorMap(name: string): Colors {
  return maps.get(name) ?? maps.get(first) ?? new Uint8Array(1024);
}
