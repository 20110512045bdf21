// Lines of any width, drawn as rectangles, because WebGL lines are one pixel wide. Instanced drawing with four vertices
// per line would use only a small part of the GPU.
import type { GeometryBatch } from "../server/geometry";

const FLOATS_PER_END = 4;
/** Width in texels of the texture with line ends, also used in LINE_VERTEX. WebGL2 guarantees 2048 texels. */
export const ENDS_PER_ROW = 2048;
export const VERTICES_PER_LINE = 6;

/** Returns x, y, z and the scalar of both ends of each line. */
export function lineEnds({ positions, scalars, indices }: GeometryBatch): Float32Array {
  const ends = new Float32Array(FLOATS_PER_END * indices.length);
  indices.forEach((vertex, at) => {
    ends.set(positions.subarray(3 * vertex, 3 * vertex + 3), FLOATS_PER_END * at);
    ends[FLOATS_PER_END * at + 3] = scalars?.[vertex] ?? 0;
  });
  return ends;
}

export function uploadLines(gl: WebGL2RenderingContext, batch: GeometryBatch): WebGLTexture {
  const rows = Math.max(Math.ceil(batch.indices.length / ENDS_PER_ROW), 1);
  const ends = new Float32Array(FLOATS_PER_END * ENDS_PER_ROW * rows);
  ends.set(lineEnds(batch));
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ENDS_PER_ROW, rows, 0, gl.RGBA, gl.FLOAT, ends);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
  return texture;
}
