// Depth peeling, as in server/render/surfaces/depth_peeling.hpp: a layer contains, at each pixel, the nearest fragment
// behind the previous layer. These layers are not the layers of the scene. After Everitt, "Interactive
// order-independent transparency", NVIDIA 2001.
import type { BatchPrograms, Picture } from "./uploaded_batches";
import { buildProgram, type Program } from "./gl_program";
import { LayerCount, MOST_LAYERS } from "./layer_count";
import {
  COVER_VERTEX,
  DEPTH_COPY_FRAGMENT,
  defining,
  LAYER_SUM_FRAGMENT,
  LAYERS_PICTURE_FRAGMENT,
} from "./peeling_shaders";
import { makeSheetTexture, SheetMaker, type Sheet, type Sheets } from "./peeling_sheets";
import { LINE_FRAGMENT, LINE_VERTEX, POINT_FRAGMENT, SURFACE_FRAGMENT, SURFACE_VERTEX } from "./shaders";

/**
 * Pictures with at most this many pixels have layers of twice the resolution. This limits the render targets to 0.4 GB:
 * they take 28 bytes per target pixel, or 44 bytes with transparent lines.
 */
const MOST_PIXELS_AT_TWICE_THE_RESOLUTION = 2 << 20;

/** Texture units of the peeling shaders' samplers. Unit 0 has the color scale. */
const UNITS = { nearer: 1, nearer_lines: 2, own_lines: 3, behind: 4, sum: 5, layer: 6 };

export interface PeeledScene {
  width: number;
  height: number;
  /** Whether the camera moves. If so, the layers have the picture's own resolution, and fewer layers are drawn. */
  moving: boolean;
  /** Whether the layers contain lines of less than full opacity. */
  joins: boolean;
  /** Draws the opaque surfaces. Only their depth is used. */
  drawOpaque(picture: Picture): void;
  drawLayer(programs: BatchPrograms, picture: Picture): void;
  /** Draws the lines of less than full opacity a second time, to join their segments. */
  joinLines(programs: BatchPrograms, picture: Picture): void;
}

export class DepthPeeling {
  private readonly programs: BatchPrograms;
  private readonly joining: BatchPrograms;
  private readonly copyDepth: Program;
  private readonly addLayer: Program;
  private readonly putOn: Program;
  private readonly maker: SheetMaker;
  private readonly queries: WebGLQuery[];
  private readonly noLines: WebGLTexture;
  private readonly count = new LayerCount();
  private sheets: Sheets | null = null;
  private made = "";
  /** Number of layers of the newest picture; 0 after the occlusion queries of these layers have been read. */
  private asked = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    const surface = this.build(SURFACE_VERTEX, defining(SURFACE_FRAGMENT, "PEELED"));
    const points = this.build(defining(SURFACE_VERTEX, "POINTS"), defining(POINT_FRAGMENT, "PEELED"));
    const lines = this.build(LINE_VERTEX, defining(LINE_FRAGMENT, "PEELED"));
    const joined = this.build(LINE_VERTEX, defining(LINE_FRAGMENT, "PEELED", "JOINING"));
    this.programs = { surface, points, lines };
    this.joining = { surface, points, lines: joined };
    this.copyDepth = this.build(COVER_VERTEX, DEPTH_COPY_FRAGMENT);
    this.addLayer = this.build(COVER_VERTEX, LAYER_SUM_FRAGMENT);
    this.putOn = this.build(COVER_VERTEX, LAYERS_PICTURE_FRAGMENT);
    this.maker = new SheetMaker(gl);
    this.queries = Array.from({ length: MOST_LAYERS }, () => gl.createQuery());
    this.noLines = makeSheetTexture(gl, gl.RGBA8, 1, 1);
  }

  free(): void {
    this.maker.free();
    this.sheets = null;
  }

  draw(scene: PeeledScene): void {
    const { gl } = this;
    const twice = scene.width * scene.height <= MOST_PIXELS_AT_TWICE_THE_RESOLUTION ? 2 : 1;
    const sheets = this.sheetsFor(twice * scene.width, twice * scene.height, scene.joins);
    // While the camera moves, only the lower left of the render targets is used, so that a drag allocates no memory.
    const pixels = scene.moving ? 1 : twice;
    const picture = { width: pixels * scene.width, height: pixels * scene.height, pixels };
    gl.viewport(0, 0, picture.width, picture.height);
    this.drawOpaque(scene, sheets, picture);
    this.begin(sheets);
    this.lacksLayers(); // reads query results that are available
    this.asked = this.count.next(scene.moving);
    let [layer, nearer] = sheets.layers;
    for (const query of this.queries.slice(0, this.asked)) {
      this.beginLayer(sheets, layer, nearer);
      gl.beginQuery(gl.ANY_SAMPLES_PASSED, query);
      scene.drawLayer(this.programs, picture);
      gl.endQuery(gl.ANY_SAMPLES_PASSED);
      if (layer.record !== null) this.join(scene, sheets, picture, layer);
      this.add(sheets);
      [layer, nearer] = [nearer, layer];
    }
    gl.viewport(0, 0, scene.width, scene.height);
    this.putOnCanvas(sheets, pixels);
  }

  /** Whether a new draw would show more layers; null until the query results are available. */
  lacksLayers(): boolean | null {
    const { gl } = this;
    const asked = this.queries.slice(0, this.asked);
    const isKnown = asked.every((query) => gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) === true);
    if (!isKnown && !gl.isContextLost()) return null;
    this.asked = 0;
    return (
      asked.length > 0 && this.count.heard(asked.map((query) => gl.getQueryParameter(query, gl.QUERY_RESULT) === 1))
    );
  }

  private build(vertex: string, fragment: string): Program {
    const program = buildProgram(this.gl, vertex, fragment);
    this.gl.useProgram(program.program);
    for (const [name, unit] of Object.entries(UNITS)) this.gl.uniform1i(program.at(name), unit);
    return program;
  }

  private sheetsFor(width: number, height: number, recorded: boolean): Sheets {
    const wanted = `${width} ${height} ${recorded}`;
    if (this.sheets === null || this.made !== wanted) this.sheets = this.maker.make(width, height, recorded);
    this.made = wanted;
    return this.sheets;
  }

  private bind(unit: keyof typeof UNITS, texture: WebGLTexture | null): void {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + UNITS[unit]);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.activeTexture(gl.TEXTURE0);
  }

  private cover(program: Program): void {
    const { gl } = this;
    gl.useProgram(program.program);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // Draws the opaque surfaces again for their depth. The depth of the canvas cannot be used, because it is
  // multisampled.
  private drawOpaque(scene: PeeledScene, { opaque }: Sheets, picture: Picture): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, opaque.framebuffer);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    scene.drawOpaque(picture);
  }

  private begin({ layers, sum }: Sheets): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, sum.framebuffer);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.bindFramebuffer(gl.FRAMEBUFFER, layers[1].framebuffer);
    gl.clearColor(0, 0, 0, 0);
    gl.clearDepth(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.clearDepth(1);
  }

  private beginLayer(sheets: Sheets, layer: Sheet, nearer: Sheet): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    gl.depthFunc(gl.ALWAYS);
    this.bind("behind", sheets.opaque.depth);
    this.bind("sum", sheets.sum.color);
    this.cover(this.copyDepth);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.LESS);
    this.bind("nearer", nearer.depth);
    this.bind("nearer_lines", nearer.record ?? this.noLines);
  }

  private join(scene: PeeledScene, { colors }: Sheets, picture: Picture, layer: Sheet): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, colors.framebuffer);
    gl.enable(gl.BLEND);
    gl.blendEquationSeparate(gl.FUNC_ADD, gl.MAX);
    gl.blendFuncSeparate(gl.ZERO, gl.ONE, gl.ONE, gl.ONE);
    this.bind("own_lines", layer.record);
    scene.joinLines(this.joining, picture);
    gl.blendEquation(gl.FUNC_ADD);
  }

  // Blends the newest layer behind the sum of the earlier layers. Colors are premultiplied.
  private add({ sum, colors }: Sheets): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, sum.framebuffer);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.DST_ALPHA, gl.ONE, gl.ZERO, gl.ONE_MINUS_SRC_ALPHA);
    this.bind("layer", colors.color);
    this.cover(this.addLayer);
  }

  private putOnCanvas({ sum }: Sheets, pixels: number): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.blendFuncSeparate(gl.ONE, gl.SRC_ALPHA, gl.ZERO, gl.ONE);
    this.bind("sum", sum.color);
    gl.useProgram(this.putOn.program);
    gl.uniform1i(this.putOn.at("pixels"), pixels);
    this.cover(this.putOn);
    gl.disable(gl.BLEND);
    gl.depthFunc(gl.LEQUAL);
  }
}
