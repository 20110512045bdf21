// A volume's opacity curve: points (position from 0 to 1 over the range, opacity per unit length), in their order.
import { clamp } from "./numbers";

export type OpacityPoint = [position: number, opacity: number];

/** As in the contract. */
export const DEFAULT_OPACITY: readonly OpacityPoint[] = [
  [0, 0],
  [1, 0.9],
];
export const MOST_POINTS = 256;

const rounded = (value: number): number => Number(clamp(value, 0, 1).toFixed(4));

/** Of values that fill most of the mesh: ten unit lengths of them, all of the box, take a seventh of the light. */
const OF_MOST = 0.015;
const AT_THE_ENDS = 0.7;
/** Narrower, an end of the range is no more than noise. */
const LEAST_TAIL = 0.02;
/** All of the range, where it is not known which values are rare. */
const UNKNOWN: readonly OpacityPoint[] = [
  [0, 0],
  [0.5, OF_MOST],
  [1, AT_THE_ENDS],
];

/** Where so many of all values are reached, from 0 to 1 along the range. */
function quantile(counts: readonly number[], share: number): number {
  const all = counts.reduce((sum, count) => sum + count, 0);
  let seen = 0;
  const bin = counts.findIndex((count) => (seen += count) >= share * all);
  return (bin + 0.5) / counts.length;
}

/** What a volume begins with: what fills most of the mesh hides next to nothing, so that the eye gets in to what is rare.
 * `counts`: a histogram over the range; null where it is not known. */
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

/** A point stays between its neighbours. */
export function moved(points: readonly OpacityPoint[], index: number, to: OpacityPoint): OpacityPoint[] {
  const low = points[index - 1]?.[0] ?? 0;
  const high = points[index + 1]?.[0] ?? 1;
  return points.map((point, i) => (i === index ? [rounded(clamp(to[0], low, high)), rounded(to[1])] : point));
}

/** With one more, and which it is. */
export function inserted(points: readonly OpacityPoint[], point: OpacityPoint): [OpacityPoint[], number] {
  const after = points.findIndex(([position]) => position > point[0]);
  const index = after < 0 ? points.length : after;
  const whole: OpacityPoint = [rounded(point[0]), rounded(point[1])];
  return [[...points.slice(0, index), whole, ...points.slice(index)], index];
}

/** A curve has one point at least. */
export const removed = (points: readonly OpacityPoint[], index: number): OpacityPoint[] =>
  points.length === 1 ? [...points] : points.filter((_, i) => i !== index);

/** Where a further point changes the curve least: in the middle of the widest gap. */
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

/** Where a key moves a point to; null where it does not. */
export function keyedPoint(key: string, shift: boolean, [position, opacity]: OpacityPoint): OpacityPoint | null {
  const step = STEPS[key];
  if (step === undefined) return null;
  const size = shift ? 0.1 : 0.01;
  return [position + step[0] * size, opacity + step[1] * size];
}
