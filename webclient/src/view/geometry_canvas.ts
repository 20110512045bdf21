// Draws the polygons of the geometry stream with WebGL2. Therefore, a camera move needs no round trip to the server.
import type { GeometryBatch } from "../server/geometry";
import { DepthPeeling } from "./depth_peeling";
import { UploadedBatches, type BatchPrograms, type Picture } from "./uploaded_batches";
import { buildProgram, type Program } from "./gl_program";
import type { Look } from "./look";
import { isSurface } from "./same_places";
import {
  BACKGROUND_FRAGMENT,
  BACKGROUND_VERTEX,
  LINE_FRAGMENT,
  LINE_VERTEX,
  POINT_FRAGMENT,
  SURFACE_FRAGMENT,
  SURFACE_VERTEX,
} from "./shaders";

const isOpaqueSurface = (batch: GeometryBatch): boolean => isSurface(batch) && batch.color[3] >= 1;
const isTransparent = (batch: GeometryBatch): boolean => batch.color[3] > 0 && batch.color[3] < 1;
// With depth peeling, the layers also contain lines and points, whose soft edges would hide the layers behind them.
const isInLayers = (batch: GeometryBatch): boolean => isTransparent(batch) || (!isSurface(batch) && batch.color[3] > 0);
const isJoined = (batch: GeometryBatch): boolean => batch.lines && isTransparent(batch);

/** The constructor throws Error if the browser has no WebGL2. */
export class GeometryCanvas {
  private readonly gl: WebGL2RenderingContext;
  private programs!: BatchPrograms;
  private background!: Program;
  private uploaded!: UploadedBatches;
  private peeling: DepthPeeling | null = null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    restored: () => void,
  ) {
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (gl === null)
      throw new Error("The browser has no WebGL2; choose the stream of images, which works without WebGL2");
    this.gl = gl;
    this.prepare();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      const { batches } = this.uploaded;
      this.prepare();
      this.setBatches(batches);
      restored();
    });
  }

  setBatches(batches: GeometryBatch[]): void {
    this.uploaded.set(batches);
    if (!this.isPeeled) this.peeling?.free();
  }

  /** Whether depth peeling is used. If so, pictures drawn while `moving` have fewer layers: draw again at rest. */
  get isPeeled(): boolean {
    return this.uploaded.has(isTransparent);
  }

  lacksLayers(): boolean | null {
    return this.isPeeled && this.peeling !== null ? this.peeling.lacksLayers() : false;
  }

  draw(look: Look, width: number, height: number, moving: boolean): void {
    const { gl } = this;
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    gl.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    this.drawBackground(look);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    const picture = { width, height, pixels: 1 };
    this.drawOpaque(look, picture);
    if (this.isPeeled) this.peel(look, width, height, moving);
    else this.drawOverlays(look, picture);
  }

  private drawOpaque(look: Look, picture: Picture): void {
    const { gl } = this;
    this.uploaded.prepare(this.programs, look, picture);
    // Moves surfaces back in depth. Otherwise a surface would cover half of each line that lies on it.
    gl.polygonOffset(this.uploaded.reachOfOverlays() * picture.pixels, 1);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    this.uploaded.draw(this.programs, look, picture.pixels, isOpaqueSurface);
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  private drawOverlays(look: Look, { pixels }: Picture): void {
    const { gl } = this;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.uploaded.draw(this.programs, look, pixels, (batch) => batch.lines);
    this.uploaded.draw(this.programs, look, pixels, (batch) => batch.points);
    gl.disable(gl.BLEND);
  }

  private peel(look: Look, width: number, height: number, moving: boolean): void {
    const { uploaded } = this;
    this.peeling ??= new DepthPeeling(this.gl);
    this.peeling.draw({
      width,
      height,
      moving,
      joins: uploaded.has(isJoined),
      drawOpaque: (picture) => this.drawOpaque(look, picture),
      drawLayer: (programs, picture) => {
        uploaded.prepare(programs, look, picture);
        uploaded.draw(programs, look, picture.pixels, isInLayers);
      },
      joinLines: (programs, picture) => {
        uploaded.prepare(programs, look, picture);
        uploaded.draw(programs, look, picture.pixels, isJoined);
      },
    });
  }

  private drawBackground(look: Look): void {
    const { gl } = this;
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.background.program);
    gl.bindVertexArray(null);
    gl.uniform3fv(this.background.at("top"), look.backgroundTop);
    gl.uniform3fv(this.background.at("bottom"), look.backgroundBottom);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  private prepare(): void {
    const { gl } = this;
    this.uploaded = new UploadedBatches(gl);
    this.peeling = null;
    this.programs = {
      surface: buildProgram(gl, SURFACE_VERTEX, SURFACE_FRAGMENT),
      lines: buildProgram(gl, LINE_VERTEX, LINE_FRAGMENT),
      points: buildProgram(gl, SURFACE_VERTEX, POINT_FRAGMENT),
    };
    this.background = buildProgram(gl, BACKGROUND_VERTEX, BACKGROUND_FRAGMENT);
  }
}
