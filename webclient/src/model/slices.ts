// Edits of slice layers: plane and looks of a new slice, change to another plane, and equal looks for all slices.
import { boundsCenter, type Bounds } from "./camera";
import type { Coloring, SliceLayer, Vec3 } from "../generated/protocol";
import { diff, equal, type JsonObject } from "./merge_patch";
import { AXES, endsOf, type Across } from "./axes";
import { clamp, widestGap } from "./numbers";

export type Slices = readonly [string, SliceLayer][];

type Looks = Pick<SliceLayer, "color" | "opacity" | "contours" | "edges">;
type Plane = Pick<SliceLayer, "axis" | "value" | "origin" | "normal">;

const NORMALS: readonly Vec3[] = [
  [1, 1, 0],
  [1, -1, 0],
  [1, 0, 1],
  [1, 0, -1],
  [0, 1, 1],
  [0, 1, -1],
];

/** Members of a slice that do not define its plane: color, opacity, contours, edges. */
const looksOf = ({ color, opacity, contours, edges }: SliceLayer): Looks => ({
  ...(color && { color }),
  ...(opacity !== undefined && { opacity }),
  ...(contours && { contours }),
  ...(edges && { edges }),
});

function freshPlane(slices: Slices, across: Across, bounds: Bounds): Plane {
  if (across !== "free") {
    const values = slices.flatMap(([, { axis, value }]) => (axis === across && value !== undefined ? [value] : []));
    return { axis: across, value: widestGap(values, endsOf(across, bounds)) };
  }
  const isUsed = (normal: Vec3): boolean => slices.some(([, slice]) => equal(slice.normal, normal));
  return { origin: boundsCenter(bounds), normal: NORMALS.find((normal) => !isUsed(normal)) ?? [1, 1, 0] };
}

/**
 * Returns a new slice. A plane across an axis lies in the widest gap between the other slices across this axis.
 * Opacity, contours and edges are copied from the last slice.
 */
export function furtherSlice(slices: Slices, across: Across, bounds: Bounds, color: Coloring): SliceLayer {
  const last = slices.at(-1)?.[1];
  return { type: "slice", ...freshPlane(slices, across, bounds), ...(last && looksOf(last)), color };
}

/**
 * Returns the changed members for another kind of plane. A plane that becomes free keeps its position. A free plane
 * that becomes perpendicular to an axis keeps the coordinate of its origin along this axis.
 */
export function planeChange(slices: Slices, slice: SliceLayer, across: Across, bounds: Bounds): object {
  const { axis, value } = slice;
  if (across === (axis ?? "free")) return {};
  if (across === "free") {
    const origin = boundsCenter(bounds).map((middle, i) => (AXES[i] === axis ? (value ?? middle) : middle));
    return { axis: null, value: null, origin, normal: AXES.map((other) => (other === axis ? 1 : 0)) };
  }
  if (axis !== undefined) return freshPlane(slices, across, bounds);
  const at = slice.origin?.[AXES.indexOf(across)] ?? 0;
  return { axis: across, value: clamp(at, ...endsOf(across, bounds)), origin: null, normal: null };
}

/** Returns the changes by layer id that give all slices the looks of slice `id`. */
export function likeThis(slices: Slices, id: string): Record<string, object> {
  const looks = looksOf(slices.find(([other]) => other === id)?.[1] ?? { type: "slice" });
  const changes = slices.map(
    ([other, slice]) => [other, diff(looksOf(slice) as JsonObject, looks as JsonObject)] as const,
  );
  return Object.fromEntries(changes.filter(([, change]) => Object.keys(change).length > 0));
}

export function looksInWords({ color, contours, edges }: SliceLayer): string {
  const lines = contours !== undefined && contours.visible !== false ? [`lines of ${contours.array}`] : [];
  const cells = edges !== undefined && edges.visible !== false ? ["cell edges"] : [];
  return [color?.array ?? "one color", ...lines, ...cells].join(", ");
}
