// Converts a scene's background to the top and bottom colors of the gradient that the server draws.
import { DEFAULTS } from "../generated/protocol";
import { isBrightBackground, namedBackground, type BackgroundColors, type Rgb } from "../wasm/background";

export function backgroundColors(background: string | undefined): BackgroundColors {
  const name = background ?? DEFAULTS.Scene.background;
  if (!/^#[0-9a-f]{6}$/i.test(name)) return namedBackground(name);
  const rgb = [1, 3, 5].map((at) => parseInt(name.slice(at, at + 2), 16) / 255) as Rgb;
  return { top: rgb, bottom: rgb };
}

/** Returns true if the background is so bright that text on it must be dark. */
export const isBright = (background: string | undefined): boolean => isBrightBackground(backgroundColors(background));
