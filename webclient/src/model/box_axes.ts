// Ticks and numbers along edges of the bounding box, over the picture: by the rules of server/render/box_edges, which
// draws them into pictures that are saved. Places are CSS pixels.
import { corners, frame, project, type Bounds, type FullCamera, type Size } from "./camera";
import { overlaps, type Box } from "./overlay_room";
import { add, scale, subtract, type Vec3 } from "./vector";
import { clamp } from "./numbers";
import { niceScale, type Scale } from "./ticks";

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
  /** The power of ten that is taken out of the numbers. */
  exponent: number;
  /** How far the numbers reach away from the edge, ticks and the gap behind them included. */
  depth: number;
}

type Axis = 0 | 1 | 2;
const NAMES = ["x", "y", "z"] as const;
// In ems, as in server/render/axes_layout.
const SHORTEST = 3;
export const TICK = 0.5;
const GAP = 0.35;
const APART = 0.5;
/** Of ticks at least, along and across the lines of text. */
const SPACING: Place = { x: 3.6, y: 2.4 };
const FEWEST_TICKS = 3;
const MOST_TICKS = 10;
/** Of a digit, wide and high: numbers have no other wide signs. */
const DIGIT: Place = { x: 0.62, y: 0.75 };
/** Of words, which have letters that reach below the line. */
const WORD_HEIGHT = 1.1;
/** Of the way along an edge, where its name may stand. */
const SHARES = [0.5, 0.4, 0.6, 0.3, 0.7, 0.15, 0.85, 0, 1];
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

const halfOf = (label: string, em: number): Place => ({ x: (label.length * DIGIT.x * em) / 2, y: (DIGIT.y * em) / 2 });

/** Moved into the picture where it would stick out: a label that is cut off says something else. */
function inside(middle: Place, half: Place, size: Size): Place {
  const within = (at: number, reach: number, end: number): number => Math.max(Math.min(at, end - reach - 1), reach + 1);
  return { x: within(middle.x, half.x, size.width), y: within(middle.y, half.y, size.height) };
}

/** The middle of a number whose nearest point is a tick's length and a gap away from the edge. */
export function numberPlace(foot: Place, outward: Place, label: string, size: Size, em: number): Place {
  const half = halfOf(label, em);
  const away = (TICK + GAP) * em + Math.abs(outward.x) * half.x + Math.abs(outward.y) * half.y;
  return inside({ x: foot.x + away * outward.x, y: foot.y + away * outward.y }, half, size);
}

/** So much of a text as the picture is wide. */
function shortened(text: string, size: Size, em: number): string {
  const most = Math.max(1, Math.floor((size.width - 2) / (DIGIT.x * em)));
  return text.length <= most ? text : `${text.slice(0, most - 1)}\u2026`;
}

interface Label extends Place {
  text: string;
}

/** Where a name may stand, best first: outside the numbers, from the middle of the edge on; past one of its ends. */
function placesOfName({ from, to, outward, depth }: BoxAxis, text: string, size: Size, em: number): Place[] {
  const half = halfOf(text, em);
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const along = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
  const away = depth + GAP * em + Math.abs(outward.x) * half.x + Math.abs(outward.y) * half.y;
  const past = (APART + 2 * GAP) * em + Math.abs(along.x) * half.x + Math.abs(along.y) * half.y;
  const places = SHARES.map((share) => ({
    x: from.x + share * (to.x - from.x) + away * outward.x,
    y: from.y + share * (to.y - from.y) + away * outward.y,
  }));
  places.push({ x: to.x + past * along.x, y: to.y + past * along.y });
  places.push({ x: from.x - past * along.x, y: from.y - past * along.y });
  return places.map((place) => inside(place, half, size));
}

/** Around text whose middle is there. */
export function boxOf({ x, y }: Place, text: string, em: number): Box {
  const half = { ...halfOf(text, em), ...(/[a-z]/.test(text) && { y: (WORD_HEIGHT * em) / 2 }) };
  return { left: x - half.x, top: y - half.y, right: x + half.x, bottom: y + half.y };
}

/** The axes without the numbers that would lie on what is taken, or on each other at a corner of the box. */
export function keptClear(axes: readonly BoxAxis[], size: Size, em: number, taken: readonly Box[]): BoxAxis[] {
  const all = [...taken];
  return axes.map((axis) => {
    const before = all.length;
    const ticks = axis.ticks.filter((tick) => {
      const box = boxOf(numberPlace(tick, axis.outward, tick.label, size, em), tick.label, em);
      const apart = (APART * em) / 2; // two numbers side by side would read as one
      const wide = { ...box, left: box.left - apart, right: box.right + apart };
      if (all.slice(0, before).some((other) => overlaps(other, wide))) return false;
      all.push(box);
      return true;
    });
    return { ...axis, ticks };
  });
}

/** One for each axis, whole and in the picture, clear of all numbers, of each other and of what is taken; null where
 * there is no room for it. */
export function placeNames(
  axes: readonly BoxAxis[],
  names: readonly string[],
  size: Size,
  em: number,
  taken: readonly Box[] = [],
): (Label | null)[] {
  const all = [...taken];
  for (const { ticks, outward } of axes)
    all.push(...ticks.map((tick) => boxOf(numberPlace(tick, outward, tick.label, size, em), tick.label, em)));
  return axes.map((axis, i) => {
    const text = shortened(names[i] ?? axis.name, size, em);
    const labels = placesOfName(axis, text, size, em).map((place) => ({ ...place, text }));
    const label = labels.find((one) => !all.some((other) => overlaps(boxOf(one, text, em), other)));
    if (label !== undefined) all.push(boxOf(label, text, em));
    return label ?? null;
  });
}

/** Whether the numbers, which are as far apart as their ticks, keep clear of each other. */
function areClear(ticks: readonly AxisTick[], em: number): boolean {
  return ticks.every((tick, i) => {
    const before = ticks[i - 1];
    if (before === undefined) return true;
    const width = ((tick.label.length + before.label.length) * DIGIT.x * em) / 2 + APART * em;
    return Math.abs(tick.x - before.x) >= width || Math.abs(tick.y - before.y) >= (DIGIT.y + APART) * em;
  });
}

/** As many marks as have room; at least one. */
function marksAlong(place: (scale: Scale) => AxisTick[], ends: [number, number], most: number, em: number) {
  for (let wanted = most; ; wanted -= 1) {
    const scale = niceScale(ends[0], ends[1], wanted);
    const ticks = place(scale);
    if (wanted <= 1 || areClear(ticks, em)) return { ticks, exponent: scale.exponent };
  }
}

interface View {
  at: (point: Vec3) => Place | null;
  middle: Place;
  size: Size;
  em: number;
}

function axisAlong(low: Vec3, high: Vec3, axis: Axis, { at, middle, size, em }: View) {
  const seen = partSeen(low, high, at, size);
  if (seen === null) return null;
  const point = (share: number): Vec3 => add(low, scale(subtract(high, low), share));
  const from = at(point(seen[0]));
  const to = at(point(seen[1]));
  if (from === null || to === null) return null;
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length < SHORTEST * em) return null;
  const half = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  let outward = { x: -(to.y - from.y) / length, y: (to.x - from.x) / length };
  if (outward.x * (half.x - middle.x) + outward.y * (half.y - middle.y) < 0) outward = { x: -outward.x, y: -outward.y };
  const spacing = (SPACING.x * Math.abs(outward.y) + SPACING.y * Math.abs(outward.x)) * em;
  const most = clamp(Math.floor(length / spacing), FEWEST_TICKS, MOST_TICKS);
  const place = (scale: Scale): AxisTick[] =>
    scale.ticks.flatMap(({ value, label }) => {
      const foot = at(point((value - low[axis]) / (high[axis] - low[axis])));
      return foot === null ? [] : [{ ...foot, label }];
    });
  const { ticks, exponent } = marksAlong(place, [point(seen[0])[axis], point(seen[1])[axis]], most, em);
  const widest = Math.max(0, ...ticks.map(({ label }) => label.length)) * DIGIT.x * em;
  const depth = (TICK + GAP) * em + Math.abs(outward.x) * widest + Math.abs(outward.y) * DIGIT.y * em;
  return { axis: { name: NAMES[axis], from, to, outward, ticks, exponent, depth }, half };
}

/** Along each axis that is seen, the leftmost silhouette edge for the one that runs up, the lowest for the others. `em`
 * is the size of the text. */
export function boxAxes(camera: FullCamera, bounds: Bounds, size: Size, em = 12): BoxAxis[] {
  const at = (point: Vec3): Place | null => project(camera, point, size);
  const { up } = frame(camera);
  const upward = ([0, 1, 2] as const).reduce<Axis>((a, b) => (Math.abs(up[b]) > Math.abs(up[a]) ? b : a), 0);
  const centre: Vec3 = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2];
  const middle = at(centre) ?? { x: size.width / 2, y: size.height / 2 };
  return ([0, 1, 2] as const).flatMap((axis): BoxAxis[] => {
    const found = edgesAlong(camera, bounds, axis).flatMap(([low, high]) => {
      const one = axisAlong(low, high, axis, { at, middle, size, em });
      return one === null ? [] : [one];
    });
    const rank = ({ half }: { half: Place }): number => (axis === upward ? -half.x : half.y);
    const best = found.sort((a, b) => rank(b) - rank(a))[0];
    return best === undefined ? [] : [best.axis];
  });
}
