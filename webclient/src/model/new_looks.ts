// How a layer looks that a hand has just made: not like those of its kind that are there, and where its array has a scale
// already, on that scale.
import { complete, type FullCamera } from "./camera";
import { dot, subtract, type Vec3 } from "./vector";
import type { Camera, ClipLayer, Coloring, DatasetDescription, Layer, Scene } from "../generated/protocol";
import { AXES } from "./axes";
import { firstScalar, fullName, layersOf, legendsOf } from "./scalars";

/** Of surfaces in one color, from the default on (after Okabe and Ito 2008: told apart by all eyes). */
export const SOLIDS = ["#cccccc", "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#d55e00", "#cc79a7", "#0072b2"] as const;

type Described = DatasetDescription | null;

/** By that array, on the scale that layers of the scene have for it: equal arrays share one legend. */
export function coloredBy(scene: Scene | null, description: Described, array: string): Coloring {
  const name = fullName(description, array);
  const shared = legendsOf(scene, description).find(({ coloring }) => coloring.array === name);
  const scale: Coloring = { ...shared?.coloring, array };
  delete scale.solid;
  return scale;
}

/** The first of the colors that no layer of that kind has. */
export function freshSolid(scene: Scene | null, type: "iso" | "surface"): Coloring {
  const taken = new Set(
    layersOf(scene, type).flatMap(([, { color }]) => (color?.array === undefined ? [color?.solid ?? SOLIDS[0]] : [])),
  );
  const solid = SOLIDS.find((color) => !taken.has(color));
  return solid === undefined || solid === SOLIDS[0] ? {} : { solid };
}

/** Of each array one: of a vector its magnitude. */
const mainScalars = (description: Described): string[] =>
  (description?.arrays ?? []).flatMap(({ name, scalars }) => {
    const main = scalars.find((scalar) => scalar === name || scalar === `${name}:magnitude`) ?? scalars[0];
    return main === undefined ? [] : [main];
  });

/** By an array that no other slice shows; where all are shown, by the first. */
export function freshArray(scene: Scene | null, description: Described): string | undefined {
  const first = firstScalar(description);
  const taken = new Set(
    layersOf(scene, "slice").flatMap(([, { color }]) =>
      color?.array === undefined ? [] : [fullName(description, color.array)],
    ),
  );
  const all = [...(first === undefined ? [] : [first]), ...mainScalars(description)];
  return all.find((scalar) => !taken.has(fullName(description, scalar))) ?? first;
}

const isWhole = (layer: Layer): boolean =>
  layer.type === "surface" && layer.visible !== false && (layer.groups ?? []).length === 0;

/** Caps stand for the data inside: they are colored by it, unless the surface that they close is. */
export function capColoring(scene: Scene | null, description: Described): Pick<ClipLayer, "color"> {
  const colored = Object.values(scene?.layers ?? {}).some(
    (layer) => isWhole(layer) && layer.type === "surface" && layer.color?.array !== undefined,
  );
  const array = firstScalar(description);
  return colored || array === undefined ? {} : { color: coloredBy(scene, description, array) };
}

/** Whether the half towards which the normal points is kept: the other one would hide the cut from that camera. */
export function keepsFarHalf(normal: Vec3, camera: Camera | FullCamera | null): boolean {
  if (camera === null) return false;
  const { position, target } = complete(camera);
  return dot(normal, subtract(position, target)) < 0;
}

export const normalOf = (across: "x" | "y" | "z" | "free"): Vec3 =>
  across === "free" ? [1, 1, 0] : (AXES.map((axis) => (axis === across ? 1 : 0)) as unknown as Vec3);
