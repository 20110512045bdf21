// Labels beside a color scale, computed by the code of server/annotations/color_ticks.hpp.
import { call } from "./layout_module";

/** Members of a color scale that determine the labels. */
interface ScaleOfLabels {
  range: readonly [number, number];
  log: boolean;
  steps: number;
}

const argumentsOf = ({ range, log, steps }: ScaleOfLabels) => [range, log, steps] as const;

/**
 * Returns the exponent of the power of ten that all labels of a scale share. The legend's title shows this power.
 * Returns 0 for a logarithmic scale.
 */
export const exponentOf = (scale: ScaleOfLabels): number => call("exponent_of", ...argumentsOf(scale)).number();

/** Returns the label of a value beside the scale. */
export const labelOn = (scale: ScaleOfLabels, value: number): string =>
  call("label_on", ...argumentsOf(scale), value).text();
