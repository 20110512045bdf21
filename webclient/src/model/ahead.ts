// Lines and texts that the page draws over the picture for changes of the scene that the picture does not contain yet.
// Lines are in CSS pixels of the canvas.
import { boundsCenter, complete, corners, project, type Bounds, type ViewCamera, type Size } from "./camera";
import { add, cross, dot, normalize, scale, subtract } from "./vector";
import type { ClipLayer, Layer, Scene, SliceLayer, Vec3 } from "../generated/protocol";
import { equal } from "./merge_patch";
import { AXES } from "./axes";
import { formatNumber } from "./numbers";

export interface Line {
  x1: number;
  y1: number;
  x2: number;
  y2: number;
}

export interface Ahead {
  lines: Line[];
  words: string[];
}

type Segment = [Vec3, Vec3];

/** Box edges as pairs of indices into corners(). The two indices of an edge differ in one bit. */
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((from) =>
  [1, 2, 4].flatMap((bit): [number, number][] => ((from & bit) === 0 ? [[from, from | bit]] : [])),
);

function boxEdges(bounds: Bounds): Segment[] {
  const all = corners(bounds);
  return EDGES.map(([from, to]) => [all[from] as Vec3, all[to] as Vec3]);
}

/** Returns the intersection of a plane with a box as sides of a convex polygon. Empty if the plane misses the box. */
export function planeOutline(origin: Vec3, normal: Vec3, bounds: Bounds): Segment[] {
  const points = boxEdges(bounds).flatMap(([from, to]): Vec3[] => {
    const [a, b] = [dot(subtract(from, origin), normal), dot(subtract(to, origin), normal)];
    if (a === b || a * b > 0) return [];
    return [add(from, scale(subtract(to, from), a / (a - b)))];
  });
  const middle = scale(points.reduce(add, [0, 0, 0]), 1 / Math.max(1, points.length));
  const right = normalize(cross(normal, Math.abs(normal[0]) < Math.abs(normal[2]) ? [1, 0, 0] : [0, 0, 1]));
  const up = cross(normalize(normal), right);
  const angle = (point: Vec3): number => {
    const arm = subtract(point, middle);
    return Math.atan2(dot(arm, up), dot(arm, right));
  };
  const around = points.sort((a, b) => angle(a) - angle(b));
  return around.length < 3 ? [] : around.map((point, i) => [point, around[(i + 1) % around.length] as Vec3]);
}

function planeOf({ axis, value, origin, normal }: SliceLayer | ClipLayer, bounds: Bounds): [Vec3, Vec3] {
  if (axis === undefined) return [origin ?? boundsCenter(bounds), normal ?? [0, 0, 1]];
  const at = AXES.indexOf(axis);
  const middle = boundsCenter(bounds);
  const on = middle.map((middle, i) => (i === at ? (value ?? middle) : middle)) as Vec3;
  return [on, AXES.map((_, i) => (i === at ? 1 : 0)) as Vec3];
}

const isPlane = (layer: Layer): layer is SliceLayer | ClipLayer => layer.type === "slice" || layer.type === "clip";
const placeOf = ({ axis, value, origin, normal }: SliceLayer | ClipLayer): string =>
  JSON.stringify([axis, value, origin, normal]);

/** Returns lines and texts for the changes from `shown` (scene of the shown picture) to `wanted` (newest scene). */
export function ahead(shown: Scene, wanted: Scene, camera: ViewCamera, bounds: Bounds, size: Size): Ahead {
  const segments: Segment[] = [];
  const words: string[] = [];
  const isTurned = !shown.camera || !wanted.camera || !equal(complete(shown.camera), complete(wanted.camera));
  if (isTurned && wanted.camera) segments.push(...boxEdges(bounds));
  for (const [id, layer] of Object.entries(wanted.layers ?? {})) {
    const before = shown.layers?.[id];
    if (layer.visible === false) continue;
    if (isPlane(layer) && !(before && isPlane(before) && placeOf(before) === placeOf(layer)))
      segments.push(...planeOutline(...planeOf(layer, bounds), bounds));
    if (layer.type === "iso" && !(before?.type === "iso" && equal(before.values, layer.values)))
      words.push(`${layer.array} = ${layer.values.map((value) => formatNumber(value)).join(", ")}`);
  }
  if (shown.time !== wanted.time && typeof wanted.time === "number") words.push(`time ${formatNumber(wanted.time)}`);
  const lines = segments.flatMap(([from, to]): Line[] => {
    const [a, b] = [project(camera, from, size), project(camera, to, size)];
    return a === null || b === null ? [] : [{ x1: a.x, y1: a.y, x2: b.x, y2: b.y }];
  });
  return { lines, words };
}
