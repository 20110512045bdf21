// Render targets of depth peeling, called sheets.

export interface Sheet {
  framebuffer: WebGLFramebuffer;
  color: WebGLTexture | null;
  depth: WebGLTexture | null;
  record: WebGLTexture | null;
}

/** The two sheets in `layers` are the current and the previous layer in turn, and share one color texture. */
export interface Sheets {
  opaque: Sheet;
  layers: [Sheet, Sheet];
  /** Framebuffer with only the color texture of the layers. */
  colors: Sheet;
  /** Sum of the light of all layers so far. Alpha is the transmittance of these layers. */
  sum: Sheet;
}

export function makeSheetTexture(
  gl: WebGL2RenderingContext,
  format: number,
  width: number,
  height: number,
): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  return texture;
}

export class SheetMaker {
  private readonly textures: WebGLTexture[] = [];
  private readonly framebuffers: WebGLFramebuffer[] = [];
  private readonly hasFloats: boolean;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.hasFloats = gl.getExtension("EXT_color_buffer_float") !== null;
  }

  /** Frees the earlier render targets. `recorded`: layers also record the last line at each pixel. */
  make(width: number, height: number, recorded: boolean): Sheets {
    const { gl } = this;
    this.free();
    const colors = this.hasFloats ? gl.RGBA16F : gl.RGBA8;
    const texture = (format: number): WebGLTexture => this.texture(format, width, height);
    const color = texture(colors);
    const layer = (): Sheet =>
      this.sheet(color, texture(gl.DEPTH_COMPONENT32F), recorded && this.hasFloats ? texture(gl.RG32F) : null);
    return {
      opaque: this.sheet(null, texture(gl.DEPTH_COMPONENT32F), null),
      layers: [layer(), layer()],
      colors: this.sheet(color, null, null),
      sum: this.sheet(texture(colors), null, null),
    };
  }

  private texture(format: number, width: number, height: number): WebGLTexture {
    const texture = makeSheetTexture(this.gl, format, width, height);
    this.textures.push(texture);
    return texture;
  }

  private sheet(color: WebGLTexture | null, depth: WebGLTexture | null, record: WebGLTexture | null): Sheet {
    const { gl } = this;
    const framebuffer = gl.createFramebuffer();
    this.framebuffers.push(framebuffer);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT1, gl.TEXTURE_2D, record, 0);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
    const first = color === null ? gl.NONE : gl.COLOR_ATTACHMENT0;
    gl.drawBuffers(record === null ? [first] : [first, gl.COLOR_ATTACHMENT1]);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost())
      throw new Error("This browser's WebGL cannot draw transparent surfaces of this size; make the window smaller");
    return { framebuffer, color, depth, record };
  }

  free(): void {
    for (const texture of this.textures.splice(0)) this.gl.deleteTexture(texture);
    for (const framebuffer of this.framebuffers.splice(0)) this.gl.deleteFramebuffer(framebuffer);
  }
}
