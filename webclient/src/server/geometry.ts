// Decodes messages of the geometry stream (kind 2 of protocol/frame.md). A message contains a batch: polygons of one
// layer.
import { MeshoptDecoder } from "meshoptimizer/decoder";
import { readFrameHeader, FRAME_HEADER_BYTES } from "../generated/frame_header";
import { scaleOf, type ColorScale } from "../model/color_scale";
import type { Coloring, Range, Vec3 } from "../generated/protocol";

/** Clip plane (nx, ny, nz, d). It keeps the points p, relative to the batch's origin, with dot(n, p) + d >= 0. */
export type ClipPlane = [number, number, number, number];

export interface GeometryBatch {
  layer: string;
  lines: boolean;
  points: boolean;
  positions: Float32Array; // offsets from `origin`, x y z per vertex
  normals: Float32Array | null;
  scalars: Float32Array | null; // offsets from `scalarOrigin`
  scalarOrigin: number;
  indices: Uint32Array;
  scale: ColorScale;
  color: [number, number, number, number];
  lit: boolean;
  width: number; // width of lines or size of points, in picture pixels
  clip: ClipPlane[];
  origin: Vec3;
}

interface SentShape {
  id: string;
  step: number;
  low: Vec3;
  bytes?: [number, number]; // sizes of the encoded vertices and indices; absent if an earlier frame had them
}

interface SentValues {
  id: string;
  of: "vertices" | "triangles" | "lines" | "points";
  step?: number; // absent if the values are floats instead of integers
  origin?: number;
  low?: number;
  bytes?: number;
}

interface BatchHeader {
  layer: string;
  kind: "triangles" | "lines" | "points";
  vertices: number;
  indices: number;
  normals: boolean;
  mesh: SentShape;
  values?: SentValues;
  map: string;
  range?: Range; // absent without scalars
  scale: Coloring;
  color: [number, number, number, number];
  lit: boolean;
  width?: number;
  clip?: ClipPlane[];
  origin: Vec3;
  batches: number;
  base: number;
}

interface BatchShape {
  positions: Float32Array;
  normals: Float32Array | null;
  indices: Uint32Array;
}

const NO_VALUE = 0xffffffff;
const CORNERS = { triangles: 3, lines: 2, points: 1 } as const;

/** Resolves when the decoder has loaded. Await before decoding a batch. Rejects if the browser has no WebAssembly. */
export const geometryReady: Promise<void> = MeshoptDecoder.ready;

/** Thrown if a batch refers to arrays of an earlier frame that are not kept. The server must send all arrays again. */
export class MissingArrays extends Error {}

/** Reads consecutive arrays of a message. Throws Error if the message is shorter or longer than its arrays. */
class Rest {
  constructor(private bytes: Uint8Array) {}

  take(count: number): Uint8Array {
    if (count > this.bytes.length)
      throw new Error("A geometry frame is damaged: its arrays are too short. Reload the page");
    const taken = this.bytes.subarray(0, count);
    this.bytes = this.bytes.subarray(count);
    return taken;
  }

  end(): void {
    if (this.bytes.length > 0)
      throw new Error(`A geometry frame is damaged: it is ${this.bytes.length} bytes too long. Reload the page`);
  }
}

/** Decoded shapes and values by id. Later batches may contain only the id instead of the arrays. */
class KeptArrays {
  private readonly kept = new Map<string, { frame: number; arrays: unknown }>();

  /**
   * Returns the arrays of the id. `decode`: decodes them from the batch; null if the batch contains only the id. In
   * this case, throws MissingArrays if the arrays are not kept.
   */
  use<Arrays>(id: string, frame: number, decode: (() => Arrays) | null): Arrays {
    const arrays = decode === null ? this.kept.get(id)?.arrays : decode();
    if (arrays === undefined)
      throw new MissingArrays(`The arrays ${id} of a geometry frame are missing. All arrays are requested again`);
    this.kept.set(id, { frame, arrays });
    return arrays as Arrays;
  }

  /** Drops the arrays that were last used before frame `base`. The server no longer refers to these arrays. */
  forgetBefore(base: number): void {
    for (const [id, { frame }] of this.kept) if (frame < base) this.kept.delete(id);
  }
}

function octahedral(place: Int8Array, at: number, normals: Float32Array, to: number): void {
  let x = (place[at] ?? 0) / 127;
  let y = (place[at + 1] ?? 0) / 127;
  const z = 1 - Math.abs(x) - Math.abs(y);
  if (z < 0) {
    const unfolded = (1 - Math.abs(y)) * (x < 0 ? -1 : 1);
    y = (1 - Math.abs(x)) * (y < 0 ? -1 : 1);
    x = unfolded;
  }
  const length = Math.hypot(x, y, z);
  normals[to] = x / length;
  normals[to + 1] = y / length;
  normals[to + 2] = z / length;
}

function decodeShape({ kind, vertices, indices, normals, mesh }: BatchHeader, rest: Rest): BatchShape {
  const [vertexBytes, indexBytes] = mesh.bytes ?? [0, 0];
  const stride = normals ? 16 : 12;
  const records = new Uint8Array(vertices * stride);
  MeshoptDecoder.decodeVertexBuffer(records, vertices, stride, rest.take(vertexBytes));
  const corners = new Uint32Array(indices);
  const target = new Uint8Array(corners.buffer);
  const source = rest.take(indexBytes);
  if (kind === "triangles") MeshoptDecoder.decodeIndexBuffer(target, indices, 4, source);
  else MeshoptDecoder.decodeIndexSequence(target, indices, 4, source);
  const places = new Uint32Array(records.buffer);
  const signed = new Int8Array(records.buffer);
  const positions = new Float32Array(3 * vertices);
  const directions = normals ? new Float32Array(3 * vertices) : null;
  for (let vertex = 0; vertex < vertices; ++vertex) {
    const at = (vertex * stride) / 4;
    for (let axis = 0; axis < 3; ++axis)
      positions[3 * vertex + axis] = ((mesh.low[axis] ?? 0) + (places[at + axis] ?? 0)) * mesh.step;
    if (directions !== null) octahedral(signed, vertex * stride + 12, directions, 3 * vertex);
  }
  return { positions, normals: directions, indices: corners };
}

/** Returns offsets from `sent.origin`, because 32-bit floats would lose digits of a small range far from 0. */
function decodeValues({ vertices, indices }: BatchHeader, sent: SentValues, rest: Rest): Float32Array {
  const count = sent.of === "vertices" ? vertices : indices / CORNERS[sent.of];
  const values = new Float32Array(count);
  MeshoptDecoder.decodeVertexBuffer(new Uint8Array(values.buffer), count, 4, rest.take(sent.bytes ?? 0));
  const { step, low = 0 } = sent;
  if (step === undefined) return values;
  const places = new Uint32Array(values.buffer);
  places.forEach((place, i) => (values[i] = place === NO_VALUE ? NaN : step * (low + place)));
  return values;
}

/** Makes one vertex for each corner, because vertices with one value per triangle, line or point cannot be shared. */
function apart(
  { positions, normals, indices }: BatchShape,
  values: Float32Array,
  corners: number,
): BatchShape & { values: Float32Array } {
  const perCorner = (of: Float32Array): Float32Array => {
    const out = new Float32Array(3 * indices.length);
    indices.forEach((vertex, i) => out.set(of.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
    return out;
  };
  return {
    positions: perCorner(positions),
    normals: normals === null ? null : perCorner(normals),
    indices: Uint32Array.from(indices.keys()),
    values: Float32Array.from(indices, (_, i) => values[Math.floor(i / corners)] ?? NaN),
  };
}

/** Decodes the frames of one view. Keeps the arrays that later frames refer to. */
export class GeometryDecoder {
  private kept = new KeptArrays();

  /** Forgets all kept arrays. Call before decoding frames of another view. */
  clear(): void {
    this.kept = new KeptArrays();
  }

  /** Returns null if the frame has no polygons. Throws Error if the sizes are inconsistent, or MissingArrays. */
  decode(message: ArrayBuffer): GeometryBatch | null {
    const bytes = message.byteLength - FRAME_HEADER_BYTES;
    if (bytes < 4) throw new Error("A geometry frame is cut off. Reload the page");
    const jsonBytes = new DataView(message).getUint32(FRAME_HEADER_BYTES, true);
    if (jsonBytes > bytes - 4) throw new Error("A geometry frame's description is cut off. Reload the page");
    const text = new TextDecoder().decode(new Uint8Array(message, FRAME_HEADER_BYTES + 4, jsonBytes));
    const header = JSON.parse(text) as BatchHeader;
    this.kept.forgetBefore(header.base);
    if (header.batches === 0) return null;
    const rest = new Rest(new Uint8Array(message, FRAME_HEADER_BYTES + 4 + jsonBytes));
    const batch = this.batchOf(header, readFrameHeader(message).frame, rest);
    rest.end();
    return batch;
  }

  private batchOf(header: BatchHeader, frame: number, rest: Rest): GeometryBatch {
    const { layer, kind, mesh, values, map, range = [0, 1], color, lit, origin } = header;
    const isNew = mesh.bytes !== undefined;
    const shape = this.kept.use(mesh.id, frame, isNew ? () => decodeShape(header, rest) : null);
    const scalars =
      values === undefined
        ? null
        : this.kept.use(values.id, frame, values.bytes === undefined ? null : () => decodeValues(header, values, rest));
    const isApart = scalars !== null && values?.of !== "vertices";
    const drawn = isApart ? apart(shape, scalars, CORNERS[kind]) : { ...shape, values: scalars };
    return {
      layer,
      lines: kind === "lines",
      points: kind === "points",
      positions: drawn.positions,
      normals: drawn.normals,
      scalars: drawn.values,
      scalarOrigin: values?.origin ?? 0,
      indices: drawn.indices,
      scale: scaleOf({ ...header.scale, map, range }, range),
      color,
      lit,
      width: header.width ?? 1,
      clip: header.clip ?? [],
      origin,
    };
  }
}
