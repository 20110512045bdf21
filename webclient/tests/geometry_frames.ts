// Encodes polygon batches as the server does, with meshoptimizer's reference encoder.
import { MeshoptEncoder } from "meshoptimizer/encoder";
import { geometryPayload } from "./frames";

await MeshoptEncoder.ready;

export const vertexStream = (records: ArrayBufferView, count: number, stride: number): Uint8Array =>
  MeshoptEncoder.encodeVertexBufferLevel(
    new Uint8Array(records.buffer, records.byteOffset, records.byteLength),
    count,
    stride,
    2,
    0,
  );

export const triangleStream = (indices: Uint32Array): Uint8Array =>
  MeshoptEncoder.encodeIndexBuffer(new Uint8Array(indices.buffer), indices.length, 4);

export const sequenceStream = (indices: Uint32Array): Uint8Array =>
  MeshoptEncoder.encodeIndexSequence(new Uint8Array(indices.buffer), indices.length, 4);

/**
 * Payload of a batch with one line from (0, 0, 0) to (1, 0, 0). `known`: refers to the mesh of an earlier frame instead
 * of containing it.
 */
export function linePayload(layer: string, known = false): Uint8Array {
  const vertices = vertexStream(Uint32Array.of(0, 0, 0, 4, 0, 0), 2, 12);
  const indices = sequenceStream(Uint32Array.of(0, 1));
  const mesh = { id: "11", step: 0.25, low: [0, 0, 0], ...(known ? {} : { bytes: [vertices.length, indices.length] }) };
  const description = { layer, kind: "lines", vertices: 2, indices: 2, normals: false, mesh, batches: 2, base: 0 };
  return geometryPayload(description, known ? [] : [vertices, indices]);
}
