// The color maps that the server draws with, from the same table.
import table from "../../../protocol/colormaps.json";

export type Colors = Uint8Array<ArrayBuffer>; // 256 RGBA

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

export const colorMapNames: readonly string[] = table.maps.map(({ name }) => name);
export const DEFAULT_MAP = "viridis";
/** Default color of missing values. */
export const missingHex = `#${table.nan}`;

/** The names grouped by the kind of map, in the table's order. */
export const colorMapKinds: readonly { kind: string; names: string[] }[] = [
  ...new Set(table.maps.map(({ kind }) => kind)),
].map((kind) => ({ kind, names: table.maps.filter((map) => map.kind === kind).map(({ name }) => name) }));

/** The named map; the first one if this page does not know the name. */
export function colorMap(name: string): Colors {
  return maps.get(name) ?? maps.get(first) ?? new Uint8Array(1024);
}
