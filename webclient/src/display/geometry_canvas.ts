// The stream of polygons, drawn by this machine: the camera answers without a round trip.
import { boundsRadius, type Bounds, type FullCamera } from "../camera/camera";
import { depthRange, projectionMatrix, viewMatrix } from "../camera/matrices";
import type { GeometryBatch } from "../decoders/geometry";
import type { Rgb } from "./background";
import type { ColorScale } from "./color_scale";
import { ScaleTextures, scaleUniforms } from "./scale_textures";
import { buildProgram, type Program } from "./gl_program";
import { BACKGROUND_FRAGMENT, BACKGROUND_VERTEX, SURFACE_FRAGMENT, SURFACE_VERTEX } from "./shaders";

export interface Look {
  camera: FullCamera;
  bounds: Bounds;
  backgroundTop: Rgb;
  backgroundBottom: Rgb;
}

interface Uploaded {
  batch: GeometryBatch;
  vertexArray: WebGLVertexArrayObject;
  buffers: WebGLBuffer[];
}

/** Throws where the browser has no WebGL2. */
export class GeometryCanvas {
  private readonly gl: WebGL2RenderingContext;
  private surface!: Program;
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
    gl.useProgram(this.surface.program);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    const depths = depthRange(look.camera, look.bounds);
    gl.uniformMatrix4fv(this.surface.at("projection"), false, projectionMatrix(look.camera, width / height, depths));
    gl.uniform1i(this.surface.at("parallel"), look.camera.parallel ? 1 : 0);
    gl.uniform1f(this.surface.at("scale"), 1 / (boundsRadius(look.bounds) || 1));
    const opaque = this.uploaded.filter(({ batch }) => batch.color[3] >= 1);
    for (const part of opaque) this.drawPart(part, look.camera);
    this.drawTransparent(look.camera);
  }

  // Each layer's nearest surface only: what lies behind it in the same layer would be mixed in no right order.
  private drawTransparent(camera: FullCamera): void {
    const { gl } = this;
    const transparent = this.uploaded.filter(({ batch }) => batch.color[3] < 1);
    const layers = new Set(transparent.map(({ batch }) => batch.layer));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const layer of layers) {
      const parts = transparent.filter(({ batch }) => batch.layer === layer);
      gl.colorMask(false, false, false, false);
      for (const part of parts) this.drawPart(part, camera);
      gl.colorMask(true, true, true, true);
      for (const part of parts) this.drawPart(part, camera);
    }
    gl.disable(gl.BLEND);
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

  private drawPart({ batch, vertexArray }: Uploaded, camera: FullCamera): void {
    const { gl, surface } = this;
    gl.uniformMatrix4fv(surface.at("view"), false, viewMatrix(camera, batch.origin));
    gl.uniform4fv(surface.at("color"), batch.color);
    gl.uniform1i(surface.at("mapped"), batch.scalars === null ? 0 : 1);
    gl.uniform1i(surface.at("lit"), batch.lit && !batch.lines ? 1 : 0);
    gl.uniform1i(surface.at("has_normals"), batch.normals === null ? 0 : 1);
    if (batch.scalars !== null) this.useScale(batch.scale);
    gl.bindVertexArray(vertexArray);
    gl.drawElements(batch.lines ? gl.LINES : gl.TRIANGLES, batch.indices.length, gl.UNSIGNED_INT, 0);
  }

  private upload(batch: GeometryBatch): Uploaded {
    const { gl } = this;
    const vertexArray = gl.createVertexArray();
    const buffers: WebGLBuffer[] = [];
    gl.bindVertexArray(vertexArray);
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
    gl.bindVertexArray(null);
    return { batch, vertexArray, buffers };
  }

  private useScale(scale: ColorScale): void {
    const { gl, surface } = this;
    const { rule, inside, below, above, missing } = scaleUniforms(scale);
    gl.uniform4fv(surface.at("rule"), rule);
    gl.uniform2fv(surface.at("inside"), inside);
    gl.uniform3fv(surface.at("below"), below);
    gl.uniform3fv(surface.at("above"), above);
    gl.uniform3fv(surface.at("missing"), missing);
    gl.bindTexture(gl.TEXTURE_2D, this.textures.of(scale));
  }

  private prepare(): void {
    this.textures = new ScaleTextures(this.gl);
    this.surface = buildProgram(this.gl, SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.background = buildProgram(this.gl, BACKGROUND_VERTEX, BACKGROUND_FRAGMENT);
  }
}
