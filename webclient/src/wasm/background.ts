// Colors of backgrounds, computed by the code of server/color/background.hpp.
import { call } from "./layout_module";

export type Rgb = [number, number, number];

/** A gradient from the top of the picture to its bottom; channels from 0 to 1. */
export interface BackgroundColors {
  top: Rgb;
  bottom: Rgb;
}

export function namedBackground(name: string): BackgroundColors {
  const results = call("named_background", name);
  const rgb = (): Rgb => [results.number(), results.number(), results.number()];
  return { top: rgb(), bottom: rgb() };
}

/** Returns true if dark text has more contrast than light text. */
export const isBrightBackground = ({ top, bottom }: BackgroundColors): boolean =>
  call("is_bright", top, bottom).number() !== 0;
