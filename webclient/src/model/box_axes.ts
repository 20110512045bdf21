// Ticks and numbers along edges of the bounding box, over the picture. The rules are those of
// server/annotations/box_edges.cpp, which lays them out in saved pictures. Coordinates are CSS pixels.
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
  /** Unit vector away from the box, perpendicular to the edge. */
  outward: Place;
  ticks: AxisTick[];
  /** Common power of ten, factored out of the labels. */
  exponent: number;
  /** Distance from the edge to the far side of the numbers, including ticks and the gap. */
  depth: number;
}

type Axis = 0 | 1 | 2;
const NAMES = ["x", "y", "z"] as const;
// In ems, as in server/annotations/axes_layout.cpp.
const SHORTEST = 3;
export const TICK = 0.5;
const GAP = 0.35;
const APART = 0.5;
/** Minimum distance of ticks, along and across the lines of text. */
const SPACING: Place = { x: 3.6, y: 2.4 };
const FEWEST_TICKS = 3;
const MOST_TICKS = 10;
/** Width and height of a digit: numbers have no wider characters. */
const DIGIT: Place = { x: 0.62, y: 0.75 };
/** Height of a word, including descenders. */
const WORD_HEIGHT = 1.1;
/** Candidate positions of a name, as shares of the edge. */
const SHARES = [0.5, 0.4, 0.6, 0.3, 0.7, 0.15, 0.85, 0, 1];
/** Sampling steps along an edge to find its visible part. */
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

/** Shares of the edge at which its first and last visible samples lie; null if fewer than two are visible. */
function partSeen(low: Vec3, high: Vec3, at: (point: Vec3) => Place | null, size: Size): [number, number] | null {
  const seen = Array.from({ length: SAMPLES + 1 }, (_, i) => i / SAMPLES).filter((share) => {
    const place = at(add(low, scale(subtract(high, low), share)));
    return place !== null && place.x >= 0 && place.y >= 0 && place.x <= size.width && place.y <= size.height;
  });
  const [from, to] = [seen[0], seen.at(-1)];
  return from === undefined || to === undefined || from === to ? null : [from, to];
}

const halfOf = (label: string, em: number): Place => ({ x: (label.length * DIGIT.x * em) / 2, y: (DIGIT.y * em) / 2 });

/** Moves a label into the picture: a number that is cut off could be misread. */
function inside(middle: Place, half: Place, size: Size): Place {
  const within = (at: number, reach: number, end: number): number => Math.max(Math.min(at, end - reach - 1), reach + 1);
  return { x: within(middle.x, half.x, size.width), y: within(middle.y, half.y, size.height) };
}

/** Center of a number whose nearest point is a tick's length and a gap away from the edge. */
export function numberPlace(foot: Place, outward: Place, label: string, size: Size, em: number): Place {
  const half = halfOf(label, em);
  const away = (TICK + GAP) * em + Math.abs(outward.x) * half.x + Math.abs(outward.y) * half.y;
  return inside({ x: foot.x + away * outward.x, y: foot.y + away * outward.y }, half, size);
}

/** Cuts a text to the width of the picture, with an ellipsis. */
function shortened(text: string, size: Size, em: number): string {
  const most = Math.max(1, Math.floor((size.width - 2) / (DIGIT.x * em)));
  return text.length <= most ? text : `${text.slice(0, most - 1)}\u2026`;
}

interface Label extends Place {
  text: string;
}

/** Candidate positions of a name, best first: outside the numbers at SHARES of the edge; then past one of its ends. */
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

/** Bounding box of a text centered at a point. */
export function boxOf({ x, y }: Place, text: string, em: number): Box {
  const half = { ...halfOf(text, em), ...(/[a-z]/.test(text) && { y: (WORD_HEIGHT * em) / 2 }) };
  return { left: x - half.x, top: y - half.y, right: x + half.x, bottom: y + half.y };
}

/** The axes without the numbers that overlap a box of `taken` or a number of an earlier axis. */
export function keptClear(axes: readonly BoxAxis[], size: Size, em: number, taken: readonly Box[]): BoxAxis[] {
  const all = [...taken];
  return axes.map((axis) => {
    const before = all.length;
    const ticks = axis.ticks.filter((tick) => {
      const box = boxOf(numberPlace(tick, axis.outward, tick.label, size, em), tick.label, em);
      const apart = (APART * em) / 2; // adjacent numbers would read as one
      const wide = { ...box, left: box.left - apart, right: box.right + apart };
      if (all.slice(0, before).some((other) => overlaps(other, wide))) return false;
      all.push(box);
      return true;
    });
    return { ...axis, ticks };
  });
}

/** One label for each axis, inside the picture, clear of all numbers, other names and `taken`; null if there is no
 * room. A name that is wider than the picture is shortened. */
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

/** Whether no numbers of adjacent ticks overlap. */
function areClear(ticks: readonly AxisTick[], em: number): boolean {
  return ticks.every((tick, i) => {
    const before = ticks[i - 1];
    if (before === undefined) return true;
    const width = ((tick.label.length + before.label.length) * DIGIT.x * em) / 2 + APART * em;
    return Math.abs(tick.x - before.x) >= width || Math.abs(tick.y - before.y) >= (DIGIT.y + APART) * em;
  });
}

/** The most ticks, up to `most`, whose labels do not overlap; falls back to a scale of at most one tick. */
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

/** One silhouette edge for each visible axis: the leftmost for the most upward axis, the lowest for the others. `em`
 * is the text size in CSS pixels. */
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
