// Textures of a color scale, for protocol/shading/color_scale.glsl. Each texture has one row.
import { colorRow, scaleRules, type ColorScale } from "../model/color_scale";

/** Number of texels of the color row. It resolves color points whose distance is 1/1024 of the range. */
const ROW_SIZE = 1024;
/** Number of textures of each kind that are kept. A drag of a color point or a range makes many textures. */
const MOST_KEPT = 16;

function colorPixels(scale: ColorScale): Uint8Array<ArrayBuffer> {
  const row = new Uint8Array(4 * ROW_SIZE);
  colorRow(scale, ROW_SIZE).forEach((color, i) => row.set([...color, 255], 4 * i));
  return row;
}

/** Keeps the MOST_KEPT most recently used items by a key, and discards all others. */
class Kept<T> {
  private readonly kept = new Map<string, T>();

  constructor(private readonly discard: (item: T) => void) {}

  of(key: string, make: () => T): T {
    const item = this.kept.get(key) ?? make();
    this.kept.delete(key);
    this.kept.set(key, item);
    const [oldest] = this.kept;
    if (this.kept.size > MOST_KEPT && oldest !== undefined) {
      this.discard(oldest[1]);
      this.kept.delete(oldest[0]);
    }
    return item;
  }
}

interface RuleTexture {
  texture: WebGLTexture;
  /** As in ScaleRules. */
  origin: number;
}

export class ScaleTextures {
  private readonly colors: Kept<WebGLTexture>;
  private readonly rules: Kept<RuleTexture>;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.colors = new Kept((texture) => gl.deleteTexture(texture));
    this.rules = new Kept(({ texture }) => gl.deleteTexture(texture));
  }

  /** Uses texture units 0 and `rulesUnit`. Returns the origin of ScaleRules. Unit 0 is active afterwards. */
  bind(scale: ColorScale, rulesUnit: number): number {
    const { gl } = this;
    const rules = this.rules.of(JSON.stringify(scale), () => this.makeRules(scale));
    const colors = this.colors.of(JSON.stringify([scale.map, scale.points, scale.reverse, scale.steps]), () =>
      this.makeColors(scale),
    );
    gl.activeTexture(gl.TEXTURE0 + rulesUnit);
    gl.bindTexture(gl.TEXTURE_2D, rules.texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, colors);
    return rules.origin;
  }

  private makeRules(scale: ColorScale): RuleTexture {
    const { gl } = this;
    const { origin, texels } = scaleRules(scale);
    const texture = this.make(gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, texels.length / 4, 1, 0, gl.RGBA, gl.FLOAT, texels);
    return { texture, origin };
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
