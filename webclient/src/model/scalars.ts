// Scalars of a dataset's arrays, and the color scales and legends of a scene. A scalar is an array with one component,
// or a component or the magnitude of a vector array.
import { scaleOf } from "./color_scale";
import { layersInOrder, type Layered } from "./layer_order";
import { formatMeasured } from "./numbers";
import { legendNameOf, legendNames } from "../wasm/legend_names";
import { prettyUnits } from "../wasm/numbers_as_text";
import type { ArrayInfo, Coloring, DatasetDescription, EmptyLayer, Layer, Range, Scene } from "../generated/protocol";

export interface Scalar {
  name: string;
  units: string;
  array: ArrayInfo;
}

/** Returns the scalars that can color the boundary: first scalars at points, then at cells, then at boundary faces. */
export function boundaryScalarsOf(description: DatasetDescription | null): Scalar[] {
  const arrays = description?.arrays ?? [];
  return (["point", "cell", "boundary_face"] as const).flatMap((of) =>
    arrays
      .filter(({ association }) => association === of)
      .flatMap((array) => array.scalars.map((name) => ({ name, units: prettyUnits(array.units), array }))),
  );
}

/** Scalars at points or cells. They can color any surface and select cells by a threshold. */
export const allScalarsOf = (description: DatasetDescription | null): Scalar[] =>
  boundaryScalarsOf(description).filter(({ array }) => array.association !== "boundary_face");

/** Scalars at points. Iso-surfaces, volumes and contours need these. */
export const scalarsOf = (description: DatasetDescription | null): Scalar[] =>
  allScalarsOf(description).filter(({ array }) => array.association === "point");

/** Returns the default scalar of new layers: that of the dataset's default scene, or the first scalar at points. */
export function firstScalar(description: DatasetDescription | null): string | undefined {
  const shown = Object.values(description?.default_scene.layers ?? {});
  for (const layer of shown) if (layer.type === "iso" || layer.type === "volume") return layer.array;
  for (const type of ["surface", "slice"])
    for (const layer of shown)
      if (
        (layer.type === "surface" || layer.type === "slice") &&
        layer.type === type &&
        layer.color?.array !== undefined
      )
        return layer.color.array;
  return scalarsOf(description)[0]?.name;
}

/** Returns "U:magnitude" for the name "U" of a vector array. Other names are unchanged. */
export function fullName(description: Pick<DatasetDescription, "arrays"> | null, scalar: string): string {
  const magnitude = `${scalar}:magnitude`;
  const hasMagnitude = description?.arrays.some(({ name, scalars }) => name === scalar && scalars.includes(magnitude));
  return hasMagnitude === true ? magnitude : scalar;
}

export const arrayOf = (description: DatasetDescription | null, scalar: string): ArrayInfo | undefined =>
  boundaryScalarsOf(description).find(({ name }) => name === scalar)?.array;

/** Also finds arrays that no layer can use, because a probe returns values of all arrays. */
const arrayNamed = (description: DatasetDescription | null, name: string): ArrayInfo | undefined =>
  arrayOf(description, name) ??
  description?.arrays.find((other) => name === other.name || name.startsWith(`${other.name}:`));

export const unitsOf = (description: DatasetDescription | null, name: string): string =>
  prettyUnits(arrayNamed(description, name)?.units ?? "");

export const measured = (description: DatasetDescription | null, name: string, value: number): string =>
  `${formatMeasured(value, arrayNamed(description, name)?.range ?? null)} ${unitsOf(description, name)}`.trim();

/** Returns null for the components of a vector array, whose ranges are unknown. */
export function rangeOfAllSteps(description: DatasetDescription | null, scalar: string): Range | null {
  const array = arrayOf(description, scalar);
  if (array === undefined || (array.components > 1 && !scalar.endsWith(":magnitude"))) return null;
  return array.range;
}

export function nearestStep(times: readonly number[], time = times[0] ?? 0): number {
  let best = 0;
  times.forEach((candidate, index) => {
    if (Math.abs(candidate - time) < Math.abs((times[best] ?? 0) - time)) best = index;
  });
  return best;
}

export const shownTime = (description: DatasetDescription | null, scene: Scene | null): number =>
  description?.times[nearestStep(description.times, scene?.time)] ?? 0;

export type LayerOf<T extends Layer["type"]> = Extract<Layer, { type: T }>;

export function layersOf<T extends Layer["type"]>(scene: Layered | null, type: T): [string, LayerOf<T>][] {
  return layersInOrder(scene).filter((entry): entry is [string, LayerOf<T>] => entry[1].type === type);
}

export function freeId(scene: Scene, prefix: string): string {
  const taken = scene.layers ?? {};
  if (!(prefix in taken)) return prefix;
  let n = 2;
  while (`${prefix}${n}` in taken) n += 1;
  return `${prefix}${n}`;
}

export const topOrder = (scene: Scene): number =>
  Object.values(scene.layers ?? {}).reduce((top, layer) => Math.max(top, layer.order ?? 0), 0) + 1;

/** Ids of the layers that use a color scale. `contours`: ids of the layers whose contour lines use the color scale. */
export interface Colored {
  layers: string[];
  contours?: string[];
}

export type ScaledColoring = Coloring & { array: string };

interface ScaleOf {
  use: keyof Colored;
  id: string;
  coloring: ScaledColoring;
}

/**
 * Returns the color scales of the caps on `layer`. [] unless it is the whole boundary, because no other layer has caps.
 */
function scalesOfCaps(scene: Layered | null, layer: Layer): ScaleOf[] {
  if (layer.type !== "surface" || (layer.groups ?? []).length > 0) return [];
  return layersOf(scene, "clip").flatMap(([id, { visible, caps, color }]) =>
    visible === false || caps === false || color?.array === undefined
      ? []
      : [{ use: "layers" as const, id, coloring: { ...color, array: color.array } }],
  );
}

function scalesOf(scene: Layered | null, id: string, layer: Layer): ScaleOf[] {
  if (layer.type === "outline" || layer.type === "clip") return [];
  const array = layer.type === "volume" ? layer.array : layer.color?.array;
  const own = array === undefined ? [] : [{ use: "layers" as const, id, coloring: { ...layer.color, array } }];
  const lines = layer.type === "slice" && layer.contours?.visible !== false ? layer.contours : undefined;
  if (lines?.coloring === undefined) return [...own, ...scalesOfCaps(scene, layer)];
  return [...own, { use: "contours", id, coloring: { ...lines.coloring, array: lines.array } }];
}

export interface LegendOf {
  coloring: ScaledColoring;
  of: Required<Colored>;
  /** Distinguishes legends of the same array. Empty if the array has only one legend. */
  name: string;
}

/**
 * Returns one legend for each distinct color scale of the visible layers, in layer order. `empty`: layers that show
 * nothing and therefore have no legend.
 */
export function legendsOf(
  scene: Layered | null,
  description: Pick<DatasetDescription, "arrays"> | null,
  empty: readonly EmptyLayer[] = [],
): LegendOf[] {
  const found = new Map<string, Omit<LegendOf, "name"> & { names: string[] }>();
  for (const [id, layer] of layersInOrder(scene)) {
    if (layer.visible === false || empty.some((one) => one.layer === id)) continue;
    for (const { use, id: of, coloring: own } of scalesOf(scene, id, layer)) {
      const coloring = { ...own, array: fullName(description, own.array) };
      const { array, range, symmetric } = coloring;
      const key = JSON.stringify([array, range ?? null, symmetric === true, scaleOf(coloring, [0, 1])]);
      const legend = found.get(key) ?? { coloring, of: { layers: [], contours: [] }, names: [] };
      if (!legend.of[use].includes(of)) legend.of[use].push(of);
      legend.names.push(legendNameOf(layer, use));
      found.set(key, legend);
    }
  }
  const legends = [...found.values()];
  const told = legendNames(legends.map(({ coloring, names }) => ({ array: coloring.array, names })));
  return legends.map(({ coloring, of }, index) => ({ coloring, of, name: told[index] ?? "" }));
}
