// Converts a scene's lighting to light strengths for the shaders.
import type { Light, Lighting } from "../generated/protocol";

export interface Lights {
  on: boolean;
  /** Strengths of ambient light, headlight and key light; 0: off. */
  strengths: [number, number, number];
}

const strengthOf = (light: Light | undefined): number => (light?.on === false ? 0 : (light?.strength ?? 1));

export function lightsOf(lighting: Lighting | undefined): Lights {
  const { on = true, ambient = 1, headlight, key_light } = lighting ?? {};
  return { on, strengths: [ambient, strengthOf(headlight), strengthOf(key_light)] };
}
