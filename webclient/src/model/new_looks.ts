// Colors of new layers: a color that no other layer of the type has, or the existing color scale of the array.
import { complete, type ViewCamera } from "./camera";
import { dot, subtract, type Vec3 } from "./vector";
import type { Camera, ClipLayer, Coloring, DatasetDescription, Layer } from "../generated/protocol";
import { AXES } from "./axes";
import type { Layered } from "./layer_order";
import { firstScalar, fullName, layersOf, legendsOf } from "./scalars";

/** The first color is the default. The others, by Okabe and Ito (2008), can be distinguished by color-blind readers. */
export const SOLIDS = ["#cccccc", "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#d55e00", "#cc79a7", "#0072b2"] as const;

type Described = DatasetDescription | null;

/**
 * Returns a coloring by `array`. Copies the scene's color scale of this array, if any, so that one legend is enough.
 */
export function coloredBy(scene: Layered | null, description: Described, array: string): Coloring {
  const name = fullName(description, array);
  const shared = legendsOf(scene, description).find(({ coloring }) => coloring.array === name);
  const scale: Coloring = { ...shared?.coloring, array };
  delete scale.solid;
  return scale;
}

/** Returns a color that no layer of this type has. {}: the default color, also returned if all colors are used. */
export function freshSolid(scene: Layered | null, type: "iso" | "surface"): Coloring {
  const taken = new Set(
    layersOf(scene, type).flatMap(([, { color }]) => (color?.array === undefined ? [color?.solid ?? SOLIDS[0]] : [])),
  );
  const solid = SOLIDS.find((color) => !taken.has(color));
  return solid === undefined || solid === SOLIDS[0] ? {} : { solid };
}

/** Returns one scalar for each array. For a vector array, this is the magnitude. */
const mainScalars = (description: Described): string[] =>
  (description?.arrays ?? []).flatMap(({ name, scalars }) => {
    const main = scalars.find((scalar) => scalar === name || scalar === `${name}:magnitude`) ?? scalars[0];
    return main === undefined ? [] : [main];
  });

/** Returns a scalar that no slice is colored by, or the first scalar if all are used. */
export function freshArray(scene: Layered | null, description: Described): string | undefined {
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

/**
 * Returns the coloring of a new clip's caps. Returns {} if a layer shows the whole boundary colored by an array,
 * because caps without a coloring have the colors of this layer.
 */
export function capColoring(scene: Layered | null, description: Described): Pick<ClipLayer, "color"> {
  const colored = Object.values(scene?.layers ?? {}).some(
    (layer) => isWhole(layer) && layer.type === "surface" && layer.color?.array !== undefined,
  );
  const array = firstScalar(description);
  return colored || array === undefined ? {} : { color: coloredBy(scene, description, array) };
}

/**
 * Returns whether a new clip must be inverted: whether its normal points away from the camera. A clip keeps the half
 * opposite to its normal, and a half on the camera's side hides the cut.
 */
export function keepsFarHalf(normal: Vec3, camera: Camera | ViewCamera | null): boolean {
  if (camera === null) return false;
  const { position, target } = complete(camera);
  return dot(normal, subtract(position, target)) < 0;
}

export const normalOf = (across: "x" | "y" | "z" | "free"): Vec3 =>
  across === "free" ? [1, 1, 0] : (AXES.map((axis) => (axis === across ? 1 : 0)) as unknown as Vec3);
