// Kind 2: one batch of polygons of one layer (protocol/frame.md).
import { HEADER_BYTES } from "../protocol/frame_header";
import type { ColorScale } from "../display/color_scale";
import type { Coloring, Range, Vec3 } from "../generated/protocol";
import { scaleOf } from "../scene/color_range";

/** nx, ny, nz, d: shown where dot(normal, offset) + d >= 0. */
export type ClipPlane = [number, number, number, number];

export interface GeometryBatch {
  layer: string;
  lines: boolean;
  points: boolean;
  positions: Float32Array; // offsets from origin
  normals: Float32Array | null;
  scalars: Float32Array | null;
  indices: Uint32Array;
  scale: ColorScale;
  color: [number, number, number, number];
  lit: boolean;
  width: number; // of lines and points, in the server's pixels
  clip: ClipPlane[];
  origin: Vec3;
}

interface BatchHeader {
  layer: string;
  kind: "triangles" | "lines" | "points";
  vertices: number;
  indices: number;
  normals: boolean;
  scalars: boolean;
  map: string;
  range?: Range; // absent where there are no scalars
  scale: Coloring;
  color: [number, number, number, number];
  lit: boolean;
  width?: number;
  clip?: ClipPlane[];
  origin: Vec3;
  batches: number;
}

/** null for a frame without polygons. The arrays are views of the message. Throws where the sizes do not agree. */
export function decodeGeometry(message: ArrayBuffer): GeometryBatch | null {
  const bytes = message.byteLength - HEADER_BYTES;
  if (bytes < 4) throw new Error("A geometry frame is cut off");
  const jsonBytes = new DataView(message).getUint32(HEADER_BYTES, true);
  if (jsonBytes % 4 !== 0 || jsonBytes > bytes - 4) throw new Error("A geometry frame's description is cut off");
  const text = new TextDecoder().decode(new Uint8Array(message, HEADER_BYTES + 4, jsonBytes));
  const header = JSON.parse(text) as BatchHeader;
  if (header.batches === 0) return null;

  const words = header.vertices * (3 + (header.normals ? 3 : 0) + (header.scalars ? 1 : 0)) + header.indices;
  if (words * 4 !== bytes - 4 - jsonBytes) {
    throw new Error(`A geometry frame's arrays have ${bytes - 4 - jsonBytes} bytes where ${words * 4} are announced`);
  }
  let offset = HEADER_BYTES + 4 + jsonBytes;
  const floats = (count: number): Float32Array => {
    const array = new Float32Array(message, offset, count);
    offset += 4 * count;
    return array;
  };
  const positions = floats(3 * header.vertices);
  const normals = header.normals ? floats(3 * header.vertices) : null;
  const scalars = header.scalars ? floats(header.vertices) : null;
  const { layer, map, range = [0, 1], color, lit, origin } = header;
  const scale = scaleOf({ ...header.scale, map, range }, range);
  const indices = new Uint32Array(message, offset, header.indices);
  return {
    layer,
    lines: header.kind === "lines",
    points: header.kind === "points",
    positions,
    normals,
    scalars,
    indices,
    scale,
    color,
    lit,
    width: header.width ?? 1,
    clip: header.clip ?? [],
    origin,
  };
}
