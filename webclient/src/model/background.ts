// Converts a scene's background to the top and bottom colors of the gradient that the server draws.
import { DEFAULTS } from "../generated/protocol";

export type Rgb = [number, number, number];

const NAMED: Record<string, { top: Rgb; bottom: Rgb }> = {
  dark: { top: [0.1, 0.12, 0.16], bottom: [0.03, 0.04, 0.05] },
  light: { top: [1, 1, 1], bottom: [0.9, 0.92, 0.95] },
};

export function backgroundColors(background: string | undefined): { top: Rgb; bottom: Rgb } {
  const name = background ?? DEFAULTS.Scene.background;
  if (/^#[0-9a-f]{6}$/i.test(name)) {
    const rgb = [1, 3, 5].map((at) => parseInt(name.slice(at, at + 2), 16) / 255) as Rgb;
    return { top: rgb, bottom: rgb };
  }
  return NAMED[name] ?? { top: [0, 0, 0], bottom: [0, 0, 0] };
}

/** Luma from 0 to 1. Text is dark on a background above this luma, and light on a darker background. */
const MIDDLE_GRAY = 0.46;
const LUMA: Rgb = [0.2126, 0.7152, 0.0722];

export function isBright(background: string | undefined): boolean {
  const { top, bottom } = backgroundColors(background);
  const luma = LUMA.reduce((sum, weight, i) => sum + (weight * ((top[i] ?? 0) + (bottom[i] ?? 0))) / 2, 0);
  return luma > MIDDLE_GRAY;
}
