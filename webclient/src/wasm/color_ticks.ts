// Positions and labels of a legend's ticks, by server/annotations/color_ticks.hpp.
import { call } from "./layout_module";

/** The members of a color scale on which its ticks depend. */
export interface ScaleOfTicks {
  range: readonly [number, number];
  log: boolean;
  steps: number;
}

export interface ColorTick {
  value: number;
  /** Position along the bar: 0 at its lower end, 1 at its upper end. */
  at: number;
  /** Text of the tick. Empty: the tick has no label. */
  label: string;
}

/** Largest number of color steps in a scene. */
const MOST_STEPS = 256;

const argumentsOf = ({ range, log, steps }: ScaleOfTicks) => [range, log, steps] as const;

/** Common power of ten of a scale's labels, shown in the legend's title. 0 for a logarithmic scale. */
export const exponentOf = (scale: ScaleOfTicks): number => call("exponent_of", ...argumentsOf(scale)).number();

/** Label of a value beside the scale. */
export const labelOn = (scale: ScaleOfTicks, value: number): string =>
  call("label_on", ...argumentsOf(scale), value).text();

/**
 * Returns the ticks in ascending order, inside the range. A range without width has one tick. `mostMarks`: largest
 * number of marked bounds of color steps.
 */
export function colorTicks(scale: ScaleOfTicks, most = 6, mostMarks = MOST_STEPS + 1): ColorTick[] {
  const results = call("color_ticks", ...argumentsOf(scale), most, mostMarks);
  return results.list(() => ({ value: results.number(), at: results.number(), label: results.text() }));
}
