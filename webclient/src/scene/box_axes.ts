// Ticks and numbers along edges of the bounding box, over the picture: by the rules of server/render/box_edges, which
// draws them into pictures that are saved. Places are CSS pixels.
import { corners, frame, project, type Bounds, type FullCamera, type Size } from "../camera/camera";
import { add, scale, subtract, type Vec3 } from "../camera/vector";
import { clamp, formatNumber, ticks } from "./numbers";

interface Place {
  x: number;
  y: number;
}
export interface AxisTick extends Place {
  label: string;
}
export interface BoxAxis {
  name: "x" | "y" | "z";
  from: Place;
  to: Place;
  /** Away from the box, across the edge; of length one. */
  outward: Place;
  ticks: AxisTick[];
}

type Axis = 0 | 1 | 2;
const NAMES = ["x", "y", "z"] as const;
const SHORTEST = 40;
/** Of ticks, along lines of text and across them. */
const SPACING: Place = { x: 44, y: 30 };
const MOST_TICKS = 10;
/** How finely an edge is searched for the part of it that is seen. */
const SAMPLES = 64;

function seesFace(camera: FullCamera, bounds: Bounds, axis: Axis, upper: boolean): boolean {
  const sign = upper ? 1 : -1;
  if (camera.parallel) return sign * frame(camera).forward[axis] < 0;
  return sign * (camera.position[axis] - (bounds[2 * axis + (upper ? 1 : 0)] ?? 0)) > 0;
}

function edgesAlong(camera: FullCamera, bounds: Bounds, axis: Axis): [Vec3, Vec3][] {
  const second = ((axis + 1) % 3) as Axis;
  const third = ((axis + 2) % 3) as Axis;
  const isUpper = (corner: Vec3, of: Axis): boolean => corner[of] === bounds[2 * of + 1];
  const onSilhouette = (corner: Vec3): boolean =>
    seesFace(camera, bounds, second, isUpper(corner, second)) !==
    seesFace(camera, bounds, third, isUpper(corner, third));
  const along = (corner: Vec3): Vec3 => {
    const far: Vec3 = [...corner];
    far[axis] = bounds[2 * axis + 1] ?? 0;
    return far;
  };
  return corners(bounds)
    .filter((corner) => !isUpper(corner, axis) && onSilhouette(corner))
    .map((corner) => [corner, along(corner)]);
}

/** The first and last of its points that are in the picture, as shares of the way. */
function partSeen(low: Vec3, high: Vec3, at: (point: Vec3) => Place | null, size: Size): [number, number] | null {
  const seen = Array.from({ length: SAMPLES + 1 }, (_, i) => i / SAMPLES).filter((share) => {
    const place = at(add(low, scale(subtract(high, low), share)));
    return place !== null && place.x >= 0 && place.y >= 0 && place.x <= size.width && place.y <= size.height;
  });
  const [from, to] = [seen[0], seen.at(-1)];
  return from === undefined || to === undefined || from === to ? null : [from, to];
}

function axisAlong(low: Vec3, high: Vec3, axis: Axis, at: (point: Vec3) => Place | null, middle: Place, size: Size) {
  const seen = partSeen(low, high, at, size);
  if (seen === null) return null;
  const point = (share: number): Vec3 => add(low, scale(subtract(high, low), share));
  const from = at(point(seen[0]));
  const to = at(point(seen[1]));
  if (from === null || to === null) return null;
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length < SHORTEST) return null;
  const half = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  let outward = { x: -(to.y - from.y) / length, y: (to.x - from.x) / length };
  if (outward.x * (half.x - middle.x) + outward.y * (half.y - middle.y) < 0) outward = { x: -outward.x, y: -outward.y };
  const spacing = SPACING.x * Math.abs(outward.y) + SPACING.y * Math.abs(outward.x);
  const wanted = clamp(Math.floor(length / spacing), 2, MOST_TICKS);
  const value = (share: number): number => point(share)[axis];
  const marks = ticks([value(seen[0]), value(seen[1])], wanted).flatMap((tick): AxisTick[] => {
    const place = at(point((tick - low[axis]) / (high[axis] - low[axis])));
    return place === null ? [] : [{ ...place, label: formatNumber(tick, value(1) - value(0)) }];
  });
  return { axis: { name: NAMES[axis], from, to, outward, ticks: marks }, half };
}

/** Along each axis that is seen, the leftmost silhouette edge for the one that runs up, the lowest for the others. */
export function boxAxes(camera: FullCamera, bounds: Bounds, size: Size): BoxAxis[] {
  const at = (point: Vec3): Place | null => project(camera, point, size);
  const { up } = frame(camera);
  const upward = ([0, 1, 2] as const).reduce<Axis>((a, b) => (Math.abs(up[b]) > Math.abs(up[a]) ? b : a), 0);
  const centre: Vec3 = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2];
  const middle = at(centre) ?? { x: size.width / 2, y: size.height / 2 };
  return ([0, 1, 2] as const).flatMap((axis): BoxAxis[] => {
    const found = edgesAlong(camera, bounds, axis).flatMap(([low, high]) => {
      const one = axisAlong(low, high, axis, at, middle, size);
      return one === null ? [] : [one];
    });
    const rank = ({ half }: { half: Place }): number => (axis === upward ? -half.x : half.y);
    const best = found.sort((a, b) => rank(b) - rank(a))[0];
    return best === undefined ? [] : [best.axis];
  });
}
