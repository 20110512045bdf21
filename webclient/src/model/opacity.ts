// Opacity curve of a volume: points with positions from 0 to 1 over the range of the color scale, in ascending order. A
// ray through one value has the opacity of this value after one unit length (VolumeLayer.unit_length).
import { DEFAULTS, LIMITS } from "../generated/protocol";
import { clamp } from "./numbers";

export type OpacityPoint = [position: number, opacity: number];

export const DEFAULT_OPACITY: readonly OpacityPoint[] = DEFAULTS.VolumeLayer.opacity_points;
export const [, MOST_POINTS] = LIMITS.VolumeLayer.opacity_points;

const rounded = (value: number): number => Number(clamp(value, 0, 1).toFixed(4));

/**
 * Opacity of common values. A ray along the diagonal (ten default unit lengths) loses a seventh of its light to them.
 */
const OF_MOST = 0.015;
const AT_THE_ENDS = 0.7;
/** The lowest or highest tenth of the values counts as rare if it covers more than this fraction of the range. */
const LEAST_TAIL = 0.02;
/** Initial curve if no rare values are known. */
const UNKNOWN: readonly OpacityPoint[] = [
  [0, 0],
  [0.5, OF_MOST],
  [1, AT_THE_ENDS],
];

/** Returns the position of the quantile `share`, from 0 to 1 along the histogram's range. */
function quantile(counts: readonly number[], share: number): number {
  const all = counts.reduce((sum, count) => sum + count, 0);
  let seen = 0;
  const bin = counts.findIndex((count) => (seen += count) >= share * all);
  return (bin + 0.5) / counts.length;
}

/**
 * Returns the opacity curve of a new volume. Common values are almost transparent, so that rare values are visible.
 * `counts`: histogram; null if unknown.
 */
export function firstOpacity(counts: readonly number[] | null): OpacityPoint[] {
  if (counts === null || !counts.some((count) => count > 0)) return [...UNKNOWN];
  const [low, high] = [quantile(counts, 0.1), quantile(counts, 0.9)];
  const [isLow, isHigh] = [low > LEAST_TAIL, 1 - high > LEAST_TAIL];
  if (!isLow && !isHigh) return [...UNKNOWN];
  const start: OpacityPoint[] = isLow
    ? [
        [0, AT_THE_ENDS],
        [rounded(low), OF_MOST],
      ]
    : [[0, 0]];
  const end: OpacityPoint[] = isHigh
    ? [
        [rounded(high), OF_MOST],
        [1, AT_THE_ENDS],
      ]
    : [[1, 0]];
  return [...start, ...end];
}

export function moved(points: readonly OpacityPoint[], index: number, to: OpacityPoint): OpacityPoint[] {
  const low = points[index - 1]?.[0] ?? 0;
  const high = points[index + 1]?.[0] ?? 1;
  return points.map((point, i) => (i === index ? [rounded(clamp(to[0], low, high)), rounded(to[1])] : point));
}

/** Returns the points including the new point, and the index of the new point. */
export function inserted(points: readonly OpacityPoint[], point: OpacityPoint): [OpacityPoint[], number] {
  const after = points.findIndex(([position]) => position > point[0]);
  const index = after < 0 ? points.length : after;
  const whole: OpacityPoint = [rounded(point[0]), rounded(point[1])];
  return [[...points.slice(0, index), whole, ...points.slice(index)], index];
}

export const removed = (points: readonly OpacityPoint[], index: number): OpacityPoint[] =>
  points.length === 1 ? [...points] : points.filter((_, i) => i !== index);

/** Returns the middle of the widest gap on the curve. Its insertion does not change the shape of the curve. */
export function middleOfGap(points: readonly OpacityPoint[]): OpacityPoint {
  const ends: OpacityPoint[] = [[0, points[0]?.[1] ?? 0], ...points, [1, points.at(-1)?.[1] ?? 0]];
  let best: OpacityPoint = [0.5, 0.5];
  let widest = -1;
  for (let i = 1; i < ends.length; i += 1) {
    const [from, to] = [ends[i - 1], ends[i]];
    if (from === undefined || to === undefined || to[0] - from[0] <= widest) continue;
    widest = to[0] - from[0];
    best = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  }
  return best;
}

const STEPS: Record<string, [number, number]> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function keyedPoint(key: string, shift: boolean, [position, opacity]: OpacityPoint): OpacityPoint | null {
  const step = STEPS[key];
  if (step === undefined) return null;
  const size = shift ? 0.1 : 0.01;
  return [position + step[0] * size, opacity + step[1] * size];
}
