// Names of the page's color maps. Their colors are in the WebAssembly module.
import { DEFAULTS } from "../generated/protocol";
import { colorMaps } from "../wasm/color_maps";

export const DEFAULT_MAP = DEFAULTS.Coloring.map;

export const colorMapNames = (): string[] => colorMaps().map(({ name }) => name);

/** Returns `name`, or the default map if the page does not know the name. Only a newer server has such a map. */
export const knownMap = (name: string): string => (colorMaps().some((map) => map.name === name) ? name : DEFAULT_MAP);

export const colorMapKinds = (): { kind: string; names: string[] }[] =>
  [...new Set(colorMaps().map(({ kind }) => kind))].map((kind) => ({
    kind,
    names: colorMaps().flatMap((map) => (map.kind === kind ? [map.name] : [])),
  }));
