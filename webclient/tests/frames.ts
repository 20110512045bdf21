// Encodes frames as described in protocol/frame.md, independently of the page's decoder.

export interface FrameFields {
  kind?: number;
  flags?: number;
  view?: number;
  frame?: number;
  revision?: bigint;
  time?: number;
  triangles?: number;
  /** Payload bytes of the whole message, if this payload is only one piece of it. */
  whole?: number;
  offset?: number;
}

export function frameBytes(fields: FrameFields, payload: Uint8Array): ArrayBuffer {
  const bytes = new ArrayBuffer(80 + payload.length);
  const view = new DataView(bytes);
  new Uint8Array(bytes).set([0x43, 0x49, 0x45, 0x4c, 2, fields.kind ?? 1]);
  view.setUint16(6, fields.flags ?? 6, true);
  view.setUint32(8, fields.view ?? 1, true);
  view.setUint32(12, fields.frame ?? 1, true);
  view.setBigUint64(16, fields.revision ?? 1n, true);
  view.setUint32(24, 640, true);
  view.setUint32(28, 480, true);
  view.setFloat64(32, fields.time ?? 0, true);
  [1.5, 2.5, 3.5, 4.5].forEach((milliseconds, i) => view.setFloat32(40 + 4 * i, milliseconds, true));
  view.setUint32(56, fields.triangles ?? 0, true);
  view.setUint32(60, payload.length, true);
  view.setUint32(64, fields.whole ?? payload.length, true);
  view.setUint32(68, fields.offset ?? 0, true);
  new Uint8Array(bytes).set(payload, 80);
  return bytes;
}

export function geometryPayload(description: object, arrays: ArrayBufferView[]): Uint8Array {
  let json = JSON.stringify(description);
  json = json.padEnd(Math.ceil(json.length / 4) * 4, " ");
  const parts: Uint8Array[] = [new Uint8Array(Uint32Array.of(json.length).buffer), new TextEncoder().encode(json)];
  for (const array of arrays) parts.push(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
  const payload = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    payload.set(part, at);
    at += part.length;
  }
  return payload;
}

export const PNG_SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
