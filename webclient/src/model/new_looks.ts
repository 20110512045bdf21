// Colors of new layers. If possible, a new layer gets a color that no layer of the same type has. Layers colored by the
// same array share one color scale.
import { complete, type FullCamera } from "./camera";
import { dot, subtract, type Vec3 } from "./vector";
import type { Camera, ClipLayer, Coloring, DatasetDescription, Layer } from "../generated/protocol";
import { AXES } from "./axes";
import type { Layered } from "./layer_order";
import { firstScalar, fullName, layersOf, legendsOf } from "./scalars";

/**
 * Solid colors of surfaces. The first color is the default. The other colors are from Okabe and Ito (2008). Color-blind
 * readers can distinguish these colors.
 */
export const SOLIDS = ["#cccccc", "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#d55e00", "#cc79a7", "#0072b2"] as const;

type Described = DatasetDescription | null;

/**
 * Returns a coloring by `array`. If the scene has a color scale of this array, the coloring is a copy of that scale.
 * The layers then share one legend.
 */
export function coloredBy(scene: Layered | null, description: Described, array: string): Coloring {
  const name = fullName(description, array);
  const shared = legendsOf(scene, description).find(({ coloring }) => coloring.array === name);
  const scale: Coloring = { ...shared?.coloring, array };
  delete scale.solid;
  return scale;
}

/**
 * Returns a coloring with the first color of SOLIDS that no layer of this type has. {} is the default color. If all
 * colors are used, also returns {}.
 */
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
 * Returns the coloring of a new clip layer's caps, by the first scalar. Returns {} if a visible layer shows the whole
 * boundary colored by an array, because the caps then have the colors of that layer.
 */
export function capColoring(scene: Layered | null, description: Described): Pick<ClipLayer, "color"> {
  const colored = Object.values(scene?.layers ?? {}).some(
    (layer) => isWhole(layer) && layer.type === "surface" && layer.color?.array !== undefined,
  );
  const array = firstScalar(description);
  return colored || array === undefined ? {} : { color: coloredBy(scene, description, array) };
}

/**
 * Whether a new clip should keep the half to which the normal points. True if the camera is on the opposite side,
 * because the other half would hide the cut.
 */
export function keepsFarHalf(normal: Vec3, camera: Camera | FullCamera | null): boolean {
  if (camera === null) return false;
  const { position, target } = complete(camera);
  return dot(normal, subtract(position, target)) < 0;
}

export const normalOf = (across: "x" | "y" | "z" | "free"): Vec3 =>
  across === "free" ? [1, 1, 0] : (AXES.map((axis) => (axis === across ? 1 : 0)) as unknown as Vec3);
