// The stream of polygons, drawn by this machine: the camera answers without a round trip.
import { boundsRadius, type Bounds, type FullCamera } from "../camera/camera";
import { depthRange, projectionMatrix, viewMatrix } from "../camera/matrices";
import type { GeometryBatch } from "../decoders/geometry";
import { clamp } from "../scene/numbers";
import type { Rgb } from "./background";
import type { ColorScale } from "./color_scale";
import type { Lights } from "./lights";
import { ScaleTextures, scaleUniforms } from "./scale_textures";
import { buildProgram, type Program } from "./gl_program";
import { uploadLines } from "./lines";
import {
  BACKGROUND_FRAGMENT,
  BACKGROUND_VERTEX,
  LINE_FRAGMENT,
  LINE_VERTEX,
  POINT_FRAGMENT,
  SURFACE_FRAGMENT,
  SURFACE_VERTEX,
} from "./shaders";

export interface Look {
  camera: FullCamera;
  bounds: Bounds;
  backgroundTop: Rgb;
  backgroundBottom: Rgb;
  lights: Lights;
}

interface Uploaded {
  batch: GeometryBatch;
  vertexArray: WebGLVertexArrayObject;
  buffers: WebGLBuffer[];
}

const isSurface = (batch: GeometryBatch): boolean => !batch.lines && !batch.points;

/** Throws where the browser has no WebGL2. */
export class GeometryCanvas {
  private readonly gl: WebGL2RenderingContext;
  private surface!: Program;
  private lines!: Program;
  private points!: Program;
  private background!: Program;
  private textures!: ScaleTextures;
  private uploaded: Uploaded[] = [];
  private batches: GeometryBatch[] = [];

  constructor(
    readonly canvas: HTMLCanvasElement,
    restored: () => void,
  ) {
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (gl === null) throw new Error("This browser has no WebGL2; the stream of images works without it");
    this.gl = gl;
    this.prepare();
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
      this.uploaded = [];
      this.prepare();
      this.setBatches(this.batches);
      restored();
    });
  }

  setBatches(batches: GeometryBatch[]): void {
    for (const { vertexArray, buffers } of this.uploaded) {
      this.gl.deleteVertexArray(vertexArray);
      for (const buffer of buffers) this.gl.deleteBuffer(buffer);
    }
    this.batches = batches;
    this.uploaded = batches.map((batch) => this.upload(batch));
  }

  draw(look: Look, width: number, height: number): void {
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
    for (const program of [this.surface, this.lines, this.points]) this.prepareProgram(program, look, width, height);
    gl.polygonOffset(this.reachOfOverlays(), 1); // surfaces a little back, so that lines on them are not half buried
    gl.enable(gl.POLYGON_OFFSET_FILL);
    this.drawParts(({ batch }) => isSurface(batch) && batch.color[3] >= 1, look);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.drawParts(({ batch }) => batch.lines, look);
    this.drawParts(({ batch }) => batch.points, look);
    this.drawTransparent(look);
    gl.disable(gl.BLEND);
    gl.disable(gl.POLYGON_OFFSET_FILL);
  }

  /** As the server has it: pixels by which lines and points reach over the place where they are. */
  private reachOfOverlays(): number {
    const widths = this.batches.map((batch) => (isSurface(batch) ? 0 : batch.width / 2 + 0.5));
    return clamp(Math.max(...widths, 1), 1, 6);
  }

  private prepareProgram(program: Program, look: Look, width: number, height: number): void {
    const { gl } = this;
    const depths = depthRange(look.camera, look.bounds);
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(program.at("projection"), false, projectionMatrix(look.camera, width / height, depths));
    gl.uniform1i(program.at("parallel"), look.camera.parallel ? 1 : 0);
    gl.uniform1f(program.at("scale"), 1 / (boundsRadius(look.bounds) || 1));
    gl.uniform2f(program.at("viewport"), width, height);
    gl.uniform3fv(program.at("lights"), look.lights.strengths);
  }

  private drawParts(wanted: (part: Uploaded) => boolean, look: Look): void {
    for (const part of this.uploaded) if (wanted(part)) this.drawPart(part, look);
  }

  // Each layer's nearest surface only: what lies behind it in the same layer would be mixed in no right order.
  private drawTransparent(look: Look): void {
    const { gl } = this;
    const isTransparent = ({ batch }: Uploaded): boolean => isSurface(batch) && batch.color[3] < 1;
    const layers = new Set(this.uploaded.filter(isTransparent).map(({ batch }) => batch.layer));
    for (const layer of layers) {
      const ofLayer = (part: Uploaded): boolean => isTransparent(part) && part.batch.layer === layer;
      gl.colorMask(false, false, false, false);
      this.drawParts(ofLayer, look);
      gl.colorMask(true, true, true, true);
      this.drawParts(ofLayer, look);
    }
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

  private drawPart({ batch, vertexArray }: Uploaded, look: Look): void {
    const { gl } = this;
    const program = batch.lines ? this.lines : batch.points ? this.points : this.surface;
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(program.at("view"), false, viewMatrix(look.camera, batch.origin));
    gl.uniform4fv(program.at("color"), batch.color);
    gl.uniform1i(program.at("mapped"), batch.scalars === null ? 0 : 1);
    gl.uniform1i(program.at("clip_planes"), batch.clip.length);
    if (batch.clip.length > 0) gl.uniform4fv(program.at("clip"), batch.clip.flat());
    if (batch.scalars !== null) this.useScale(program, batch.scale);
    gl.uniform1i(program.at("lit"), batch.lit && look.lights.on ? 1 : 0);
    gl.bindVertexArray(vertexArray);
    if (batch.lines) {
      gl.uniform1f(program.at("half_width"), batch.width / 2);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, batch.indices.length / 2);
      return;
    }
    if (batch.points) {
      gl.uniform1f(program.at("point_size"), batch.width);
      gl.drawElements(gl.POINTS, batch.indices.length, gl.UNSIGNED_INT, 0);
      return;
    }
    gl.uniform1i(program.at("has_normals"), batch.normals === null ? 0 : 1);
    gl.drawElements(gl.TRIANGLES, batch.indices.length, gl.UNSIGNED_INT, 0);
  }

  private upload(batch: GeometryBatch): Uploaded {
    const { gl } = this;
    const vertexArray = gl.createVertexArray();
    gl.bindVertexArray(vertexArray);
    const buffers = batch.lines ? uploadLines(gl, batch) : this.uploadSurface(batch);
    gl.bindVertexArray(null);
    return { batch, vertexArray, buffers };
  }

  private uploadSurface(batch: GeometryBatch): WebGLBuffer[] {
    const { gl } = this;
    const buffers: WebGLBuffer[] = [];
    [batch.positions, batch.normals, batch.scalars].forEach((values, location) => {
      if (values === null) return;
      const buffer = gl.createBuffer();
      buffers.push(buffer);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, location === 2 ? 1 : 3, gl.FLOAT, false, 0, 0);
    });
    const indices = gl.createBuffer();
    buffers.push(indices);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, batch.indices, gl.STATIC_DRAW);
    return buffers;
  }

  private useScale(program: Program, scale: ColorScale): void {
    const { gl } = this;
    const { rule, inside, below, above, missing } = scaleUniforms(scale);
    gl.uniform4fv(program.at("rule"), rule);
    gl.uniform2fv(program.at("inside"), inside);
    gl.uniform3fv(program.at("below"), below);
    gl.uniform3fv(program.at("above"), above);
    gl.uniform3fv(program.at("missing"), missing);
    gl.bindTexture(gl.TEXTURE_2D, this.textures.of(scale));
  }

  private prepare(): void {
    this.textures = new ScaleTextures(this.gl);
    this.surface = buildProgram(this.gl, SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.lines = buildProgram(this.gl, LINE_VERTEX, LINE_FRAGMENT);
    this.points = buildProgram(this.gl, SURFACE_VERTEX, POINT_FRAGMENT);
    this.background = buildProgram(this.gl, BACKGROUND_VERTEX, BACKGROUND_FRAGMENT);
  }
}
