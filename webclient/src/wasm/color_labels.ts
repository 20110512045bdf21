// Labels beside a color scale, by server/annotations/color_ticks.hpp.
import { call } from "./layout_module";

/** The members of a color scale on which its labels depend. */
interface ScaleOfLabels {
  range: readonly [number, number];
  log: boolean;
  steps: number;
}

const argumentsOf = ({ range, log, steps }: ScaleOfLabels) => [range, log, steps] as const;

/** Common power of ten of a scale's labels, shown in the legend's title. 0 for a logarithmic scale. */
export const exponentOf = (scale: ScaleOfLabels): number => call("exponent_of", ...argumentsOf(scale)).number();

/** Label of a value beside the scale. */
export const labelOn = (scale: ScaleOfLabels, value: number): string =>
  call("label_on", ...argumentsOf(scale), value).text();
