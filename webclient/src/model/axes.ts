// Coordinate axes, and the range of a bounding box along an axis.
import type { Bounds } from "./camera";
import type { Range } from "../generated/protocol";

export const AXES = ["x", "y", "z"] as const;
export type Axis = (typeof AXES)[number];
/** Axis to which a plane is perpendicular. A "free" plane has an origin and a normal instead. */
export type Across = Axis | "free";

export function endsOf(axis: Axis, bounds: Bounds): Range {
  const at = 2 * AXES.indexOf(axis);
  return [bounds[at] ?? 0, bounds[at + 1] ?? 1];
}
