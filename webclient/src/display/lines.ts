// Lines of any width: each one an instance of a rectangle, for WebGL draws no line wider than a pixel.
import type { GeometryBatch } from "../decoders/geometry";

const FLOATS_PER_END = 4;

/** x, y, z and value of both ends, line after line. */
export function lineEnds({ positions, scalars, indices }: GeometryBatch): Float32Array {
  const ends = new Float32Array(FLOATS_PER_END * indices.length);
  indices.forEach((vertex, at) => {
    ends.set(positions.subarray(3 * vertex, 3 * vertex + 3), FLOATS_PER_END * at);
    ends[FLOATS_PER_END * at + 3] = scalars?.[vertex] ?? 0;
  });
  return ends;
}

/** Attributes 0 and 1 of the bound vertex array: the ends of each instance. */
export function uploadLines(gl: WebGL2RenderingContext, batch: GeometryBatch): WebGLBuffer[] {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, lineEnds(batch), gl.STATIC_DRAW);
  for (const end of [0, 1]) {
    gl.enableVertexAttribArray(end);
    gl.vertexAttribPointer(end, FLOATS_PER_END, gl.FLOAT, false, 2 * FLOATS_PER_END * 4, end * FLOATS_PER_END * 4);
    gl.vertexAttribDivisor(end, 1);
  }
  return [buffer];
}
