// Textures of a color scale, for protocol/shading/color_scale.glsl. Each texture has one row.
import {
  bytesOf,
  colorRow,
  hasWidth,
  limitsOf,
  type ColorScale,
  type Rgb8,
  isLogOfBothSigns,
  LINEAR_SHARE,
} from "../model/color_scale";
import type { Rgb } from "../model/background";

/** Number of texels of the color row. It resolves color points whose distance is 1/1024 of the range. */
const ROW_SIZE = 1024;
/** Number of textures of each kind that are kept. A drag of a color point or a range makes many textures. */
const MOST_KEPT = 16;

/** All members are finite 32-bit floats. */
export interface ScaleRules {
  /** Subtracted from values and limits. Values of a small range far from 0 then keep their digits as 32-bit floats. */
  origin: number;
  /** Low end, 1 / width, number of steps, and way, as defined in color_scale.glsl. */
  rule: [number, number, number, number];
  inside: [number, number];
  below: Rgb;
  above: Rgb;
  missing: Rgb;
}

const unit = (color: Rgb8): Rgb => color.map((channel) => channel / 255) as Rgb;

/** Largest low end that is used as origin. With a larger origin, value - origin may overflow a 32-bit float. */
const FARTHEST_ORIGIN = 1e37;

const originOf = ({ log, range: [low] }: ColorScale): number =>
  log || Math.abs(low) > FARTHEST_ORIGIN ? 0 : Math.fround(low);

export function scaleRules(scale: ColorScale): ScaleRules {
  const isOfBothSigns = isLogOfBothSigns(scale);
  const linear = Math.max(LINEAR_SHARE * scale.range[1], 1e-37);
  const measure = (value: number): number => {
    if (isOfBothSigns) return Math.sign(value) * Math.log2(1 + Math.abs(value) / linear);
    return scale.log ? Math.log2(value) : value;
  };
  const low = hasWidth(scale) ? measure(scale.range[0]) : scale.range[0];
  // Replaces infinity, because shaders need not support infinity.
  const largest = 3e38;
  const scaling = hasWidth(scale) ? Math.min(1 / (measure(scale.range[1]) - low), largest) : 0;
  const origin = originOf(scale);
  const [first = [0, 0, 0], last = first] = colorRow({ ...scale, steps: 0 }, 2);
  const [lowest, highest] = limitsOf(scale);
  return {
    origin,
    rule: [low - origin, scaling, scale.steps, isOfBothSigns ? -linear : scale.log ? 1 : 0],
    inside: [Math.max(lowest - origin, -largest), Math.min(highest - origin, largest)],
    below: unit(scale.below === null ? first : bytesOf(scale.below)),
    above: unit(scale.above === null ? last : bytesOf(scale.above)),
    missing: unit(bytesOf(scale.nan)),
  };
}

function colorPixels(scale: ColorScale): Uint8Array<ArrayBuffer> {
  const row = new Uint8Array(4 * ROW_SIZE);
  colorRow(scale, ROW_SIZE).forEach((color, i) => row.set([...color, 255], 4 * i));
  return row;
}

const rulePixels = ({ rule, inside, below, above, missing }: ScaleRules): Float32Array<ArrayBuffer> =>
  new Float32Array([...rule, ...inside, 0, 0, ...below, 1, ...above, 1, ...missing, 1]);

/** Textures by a key. Keeps the MOST_KEPT most recently used textures and deletes all others. */
class KeptTextures {
  private readonly kept = new Map<string, WebGLTexture>();

  constructor(private readonly gl: WebGL2RenderingContext) {}

  of(key: string, make: () => WebGLTexture): WebGLTexture {
    const texture = this.kept.get(key) ?? make();
    this.kept.delete(key);
    this.kept.set(key, texture);
    const [oldest] = this.kept;
    if (this.kept.size > MOST_KEPT && oldest !== undefined) {
      this.gl.deleteTexture(oldest[1]);
      this.kept.delete(oldest[0]);
    }
    return texture;
  }
}

export class ScaleTextures {
  private readonly colors: KeptTextures;
  private readonly rules: KeptTextures;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.colors = new KeptTextures(gl);
    this.rules = new KeptTextures(gl);
  }

  /** Uses texture units 0 and `rulesUnit`. Returns the origin of ScaleRules. Unit 0 is active afterwards. */
  bind(scale: ColorScale, rulesUnit: number): number {
    const { gl } = this;
    const rules = scaleRules(scale);
    const pixels = rulePixels(rules);
    const ruleTexture = this.rules.of(pixels.join(), () => this.makeRules(pixels));
    const colorTexture = this.colors.of(JSON.stringify([scale.map, scale.points, scale.reverse, scale.steps]), () =>
      this.makeColors(scale),
    );
    gl.activeTexture(gl.TEXTURE0 + rulesUnit);
    gl.bindTexture(gl.TEXTURE_2D, ruleTexture);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, colorTexture);
    return rules.origin;
  }

  private makeRules(pixels: Float32Array<ArrayBuffer>): WebGLTexture {
    const { gl } = this;
    const texture = this.make(gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, pixels.length / 4, 1, 0, gl.RGBA, gl.FLOAT, pixels);
    return texture;
  }

  private makeColors(scale: ColorScale): WebGLTexture {
    const { gl } = this;
    const texture = this.make(gl.LINEAR);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, ROW_SIZE, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colorPixels(scale));
    return texture;
  }

  /** Makes a texture and binds it to the active unit. */
  private make(filter: GLenum): WebGLTexture {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const [name, value] of [
      [gl.TEXTURE_MIN_FILTER, filter],
      [gl.TEXTURE_MAG_FILTER, filter],
      [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
      [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE],
    ] as const) {
      gl.texParameteri(gl.TEXTURE_2D, name, value);
    }
    return texture;
  }
}
