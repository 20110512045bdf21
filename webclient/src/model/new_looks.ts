// Colors of a new layer. They differ from those of existing layers of the same type. Layers of the same array share its
// color scale.
import { complete, type FullCamera } from "./camera";
import { dot, subtract, type Vec3 } from "./vector";
import type { Camera, ClipLayer, Coloring, DatasetDescription, Layer } from "../generated/protocol";
import { AXES } from "./axes";
import type { Layered } from "./layer_order";
import { firstScalar, fullName, layersOf, legendsOf } from "./scalars";

/**
 * Solid colors of surfaces, the default first. They are those of Okabe and Ito (2008), safe for color-blind readers.
 */
export const SOLIDS = ["#cccccc", "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#d55e00", "#cc79a7", "#0072b2"] as const;

type Described = DatasetDescription | null;

/**
 * Coloring by `array`. Copies the scene's color scale of that array if there is one, so that the layers share one
 * legend.
 */
export function coloredBy(scene: Layered | null, description: Described, array: string): Coloring {
  const name = fullName(description, array);
  const shared = legendsOf(scene, description).find(({ coloring }) => coloring.array === name);
  const scale: Coloring = { ...shared?.coloring, array };
  delete scale.solid;
  return scale;
}

/** Returns the first of SOLIDS that no layer of the type has. {} stands for the default color. */
export function freshSolid(scene: Layered | null, type: "iso" | "surface"): Coloring {
  const taken = new Set(
    layersOf(scene, type).flatMap(([, { color }]) => (color?.array === undefined ? [color?.solid ?? SOLIDS[0]] : [])),
  );
  const solid = SOLIDS.find((color) => !taken.has(color));
  return solid === undefined || solid === SOLIDS[0] ? {} : { solid };
}

/** One scalar for each array. For a vector it is the magnitude. */
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
 * Coloring of a new clip layer's caps by the first scalar. Empty if a visible layer shows the whole boundary colored by
 * an array, because the caps then have the colors of that layer.
 */
export function capColoring(scene: Layered | null, description: Described): Pick<ClipLayer, "color"> {
  const colored = Object.values(scene?.layers ?? {}).some(
    (layer) => isWhole(layer) && layer.type === "surface" && layer.color?.array !== undefined,
  );
  const array = firstScalar(description);
  return colored || array === undefined ? {} : { color: coloredBy(scene, description, array) };
}

/**
 * Whether a clip should keep the half that the normal points to. True if the other half would hide the cut from the
 * camera.
 */
export function keepsFarHalf(normal: Vec3, camera: Camera | FullCamera | null): boolean {
  if (camera === null) return false;
  const { position, target } = complete(camera);
  return dot(normal, subtract(position, target)) < 0;
}

export const normalOf = (across: "x" | "y" | "z" | "free"): Vec3 =>
  across === "free" ? [1, 1, 0] : (AXES.map((axis) => (axis === across ? 1 : 0)) as unknown as Vec3);
