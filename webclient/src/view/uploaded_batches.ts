// The batches of a frame in GPU memory, and the draw calls for them.
import { boundsRadius } from "../model/camera";
import { depthRange, projectionMatrix, viewMatrix } from "./matrices";
import type { GeometryBatch } from "../server/geometry";
import { clamp } from "../model/numbers";
import type { Program } from "./gl_program";
import { uploadLines, VERTICES_PER_LINE } from "./lines";
import type { Look } from "./look";
import { isSurface, placesOf } from "./same_places";
import { ScaleTextures } from "./scale_textures";

/** Texture unit of line ends. Unit 0 has the colors of the scale; depth_peeling.ts uses units 1 to 6. */
const ENDS_UNIT = 7;
const RULES_UNIT = 8;

export interface BatchPrograms {
  surface: Program;
  lines: Program;
  points: Program;
}

interface UploadedBatch {
  batch: GeometryBatch;
  place: number;
  vertexArray: WebGLVertexArrayObject;
  buffers: WebGLBuffer[];
  /** Texture with the ends of the batch's lines; null for surfaces and points. */
  ends: WebGLTexture | null;
}

/** Size of the render target in pixels. `pixels`: target pixels per picture pixel along one side. */
export interface Picture {
  width: number;
  height: number;
  pixels: number;
}

/** Compares references, because the decoder returns the same object for an unchanged array. */
const isSameShape = (a: GeometryBatch, b: GeometryBatch): boolean =>
  a.positions === b.positions &&
  a.normals === b.normals &&
  a.scalars === b.scalars &&
  a.indices === b.indices &&
  a.lines === b.lines &&
  a.points === b.points;

export class UploadedBatches {
  private readonly textures: ScaleTextures;
  private uploads: UploadedBatch[] = [];

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.textures = new ScaleTextures(gl);
  }

  get batches(): GeometryBatch[] {
    return this.uploads.map(({ batch }) => batch);
  }

  set(batches: GeometryBatch[]): void {
    const before = new Set(this.uploads);
    const places = placesOf(batches);
    this.uploads = batches.map((batch, i) => {
      const place = places[i] ?? 0;
      for (const uploaded of before) {
        if (!isSameShape(uploaded.batch, batch)) continue;
        before.delete(uploaded);
        return { ...uploaded, batch, place };
      }
      return this.upload(batch, place);
    });
    for (const uploaded of before) this.free(uploaded);
  }

  private free({ vertexArray, buffers, ends }: UploadedBatch): void {
    this.gl.deleteVertexArray(vertexArray);
    this.gl.deleteTexture(ends);
    for (const buffer of buffers) this.gl.deleteBuffer(buffer);
  }

  has(wanted: (batch: GeometryBatch) => boolean): boolean {
    return this.uploads.some(({ batch }) => wanted(batch));
  }

  /** Returns the distance from the middle of the widest line or point to its edge, in picture pixels, from 1 to 6. */
  reachOfOverlays(): number {
    const widths = this.uploads.map(({ batch }) => (isSurface(batch) ? 0 : batch.width / 2 + 0.5));
    return clamp(Math.max(...widths, 1), 1, 6);
  }

  /** Call once per picture and before draw(). */
  prepare({ surface, lines, points }: BatchPrograms, look: Look, { width, height, pixels }: Picture): void {
    const { gl } = this;
    const depths = depthRange(look.camera, look.bounds);
    const reach = this.has((batch) => !isSurface(batch)) ? this.reachOfOverlays() : 0;
    for (const program of [surface, lines, points]) {
      gl.useProgram(program.program);
      gl.uniformMatrix4fv(program.at("projection"), false, projectionMatrix(look.camera, width / height, depths));
      gl.uniform1i(program.at("parallel"), look.camera.parallel ? 1 : 0);
      gl.uniform1f(program.at("scale"), 1 / (boundsRadius(look.bounds) || 1));
      gl.uniform2f(program.at("viewport"), width, height);
      gl.uniform1f(program.at("reach"), reach * pixels);
      gl.uniform3fv(program.at("lights"), look.lights.strengths);
    }
  }

  draw(programs: BatchPrograms, look: Look, pixels: number, wanted: (batch: GeometryBatch) => boolean): void {
    for (const uploaded of this.uploads)
      if (wanted(uploaded.batch)) this.drawUploaded(programs, look, pixels, uploaded);
  }

  private drawUploaded(programs: BatchPrograms, look: Look, pixels: number, uploaded: UploadedBatch): void {
    const { batch, place, vertexArray, ends } = uploaded;
    const { gl } = this;
    const program = batch.lines ? programs.lines : batch.points ? programs.points : programs.surface;
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(program.at("view"), false, viewMatrix(look.camera, batch.origin));
    gl.uniform4fv(program.at("color"), batch.color);
    gl.uniform1f(program.at("scale_row"), batch.scalars === null ? -1 : 0);
    gl.uniform1i(program.at("clip_planes"), batch.clip.length);
    if (batch.clip.length > 0) gl.uniform4fv(program.at("clip"), batch.clip.flat());
    if (batch.scalars !== null) this.useScale(program, batch);
    gl.uniform1i(program.at("lit"), batch.lit && look.lights.on ? 1 : 0);
    gl.uniform1f(program.at("place_in_order"), place);
    gl.bindVertexArray(vertexArray);
    if (batch.lines) {
      gl.uniform1f(program.at("half_width"), (batch.width / 2) * pixels);
      gl.uniform1i(program.at("ends"), ENDS_UNIT);
      gl.activeTexture(gl.TEXTURE0 + ENDS_UNIT);
      gl.bindTexture(gl.TEXTURE_2D, ends);
      gl.activeTexture(gl.TEXTURE0);
      gl.drawArrays(gl.TRIANGLES, 0, (batch.indices.length / 2) * VERTICES_PER_LINE);
      return;
    }
    if (batch.points) {
      gl.uniform1f(program.at("point_size"), batch.width * pixels);
      gl.drawElements(gl.POINTS, batch.indices.length, gl.UNSIGNED_INT, 0);
      return;
    }
    gl.uniform1i(program.at("has_normals"), batch.normals === null ? 0 : 1);
    gl.drawElements(gl.TRIANGLES, batch.indices.length, gl.UNSIGNED_INT, 0);
  }

  private upload(batch: GeometryBatch, place: number): UploadedBatch {
    const { gl } = this;
    const vertexArray = gl.createVertexArray();
    if (batch.lines) return { batch, place, vertexArray, buffers: [], ends: uploadLines(gl, batch) };
    gl.bindVertexArray(vertexArray);
    const buffers = this.uploadVertices(batch);
    gl.bindVertexArray(null);
    return { batch, place, vertexArray, buffers, ends: null };
  }

  private uploadVertices(batch: GeometryBatch): WebGLBuffer[] {
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

  private useScale(program: Program, { scale, scalarOrigin }: GeometryBatch): void {
    const { gl } = this;
    gl.uniform1i(program.at("scale_rules"), RULES_UNIT);
    gl.uniform1f(program.at("value_origin"), this.textures.bind(scale, RULES_UNIT) - scalarOrigin);
  }
}
