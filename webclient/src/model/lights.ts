// Converts a scene's lighting to light strengths for the shaders.
import { DEFAULTS, type Light, type Lighting } from "../generated/protocol";

export interface Lights {
  on: boolean;
  /** Strengths of ambient light, headlight and key light; 0: off. */
  strengths: [number, number, number];
}

const strengthOf = ({ on = DEFAULTS.Light.on, strength = DEFAULTS.Light.strength }: Light = {}): number =>
  on ? strength : 0;

export function lightsOf(lighting: Lighting = {}): Lights {
  const { on, ambient, headlight, key_light } = { ...DEFAULTS.Lighting, ...lighting };
  return { on, strengths: [ambient, strengthOf(headlight), strengthOf(key_light)] };
}
