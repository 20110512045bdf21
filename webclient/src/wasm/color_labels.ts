// Labels beside a color scale, computed by the code of server/annotations/color_ticks.hpp.
import { call } from "./layout_module";

interface ScaleOfLabels {
  range: readonly [number, number];
  log: boolean;
  steps: number;
}

const argumentsOf = ({ range, log, steps }: ScaleOfLabels) => [range, log, steps] as const;

/** Exponent of the power of ten that all labels share and the legend's title shows; 0 for a logarithmic scale. */
export const exponentOf = (scale: ScaleOfLabels): number => call("exponent_of", ...argumentsOf(scale)).number();

export const labelOn = (scale: ScaleOfLabels, value: number): string =>
  call("label_on", ...argumentsOf(scale), value).text();
