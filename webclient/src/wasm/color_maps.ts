// Names of the color maps whose colors are in the WebAssembly module.
import { call } from "./layout_module";

export interface ColorMap {
  name: string;
  /** "sequential", "diverging" or "cyclic". */
  kind: string;
}

let maps: readonly ColorMap[] | null = null;

function askedMaps(): ColorMap[] {
  const results = call("color_maps");
  return results.list(() => ({ name: results.text(), kind: results.text() }));
}

/** In the order of protocol/colormaps.json. The module is asked only once. */
export const colorMaps = (): readonly ColorMap[] => (maps ??= askedMaps());
