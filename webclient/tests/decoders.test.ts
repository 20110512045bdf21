import { describe, expect, test } from "vitest";
import { decodeGeometry } from "../src/decoders/geometry";
import { pictureOf } from "../src/decoders/image";
import { lineEnds } from "../src/display/lines";
import { decodeHeader } from "../src/protocol/frame_header";
import { frameBytes, geometryPayload, PNG_SIGNATURE } from "./frames";

const batch = {
  layer: "iso",
  kind: "triangles",
  vertices: 3,
  indices: 3,
  normals: true,
  scalars: true,
  map: "viridis",
  range: [0.5, 2],
  scale: {
    reverse: true,
    log: true,
    steps: 4,
    below: "#ff0000",
    points: [
      { at: 0, color: "#000000" },
      { at: 1, color: "#ffffff" },
    ],
  },
  color: [0.5, 0.5, 0.5, 1],
  lit: true,
  origin: [1e6, 0, 0],
  batch: 0,
  batches: 1,
};
const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
const normals = Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1);
const scalars = Float32Array.of(0, 1, 2);
const indices = Uint32Array.of(0, 1, 2);

describe("frame header", () => {
  test("every field at its offset", () => {
    const message = frameBytes(
      { kind: 1, flags: 5, view: 7, frame: 9, revision: 2n ** 40n, time: 0.125, triangles: 1234 },
      PNG_SIGNATURE,
    );
    expect(decodeHeader(message)).toEqual({
      kind: 1,
      flags: 5,
      still: true,
      last: false,
      first: true,
      view: 7,
      frame: 9,
      revision: 2 ** 40,
      width: 640,
      height: 480,
      time: 0.125,
      waitMs: 1.5,
      extractMs: 2.5,
      drawMs: 3.5,
      encodeMs: 4.5,
      triangles: 1234,
      payloadBytes: 8,
      wholeBytes: 8,
      pieceOffset: 0,
    });
  });

  const changed = (at: number, value: number): ArrayBuffer => {
    const message = frameBytes({}, PNG_SIGNATURE);
    new Uint8Array(message)[at] = value;
    return message;
  };
  test.each([
    { name: "short", message: new ArrayBuffer(79), error: "shorter than its header" },
    { name: "foreign", message: changed(0, 0x58), error: "not a CIEL frame" },
    { name: "another version", message: changed(4, 1), error: "frames of version 1" },
    { name: "cut off", message: frameBytes({}, PNG_SIGNATURE).slice(0, 85), error: "announces 8 bytes and brings 5" },
    { name: "too long", message: changed(60, 7), error: "announces 7 bytes and brings 8" },
    { name: "behind its whole", message: changed(68, 1), error: "ends behind its 8 bytes" },
  ])("refuses a message that is $name", ({ message, error }) => {
    expect(() => decodeHeader(message)).toThrow(error);
  });
});

describe("image", () => {
  test.each([
    { type: "image/png", signature: PNG_SIGNATURE },
    { type: "image/jpeg", signature: [0xff, 0xd8, 0xff] },
  ])("the payload is the $type", async ({ type, signature }) => {
    const picture = Uint8Array.of(...signature, 1, 2, 3);
    const blob = pictureOf(frameBytes({}, picture));
    expect(blob.type).toBe(type);
    expect(new Uint8Array(await blob.arrayBuffer())).toEqual(picture);
  });

  test.each([
    { payload: [] },
    { payload: [0xff, 0xd8] },
    { payload: PNG_SIGNATURE.slice(0, 7) },
    { payload: [0x47, 0x49, 0x46, 0x38] },
  ])("$payload is refused", ({ payload }) => {
    expect(() => pictureOf(frameBytes({}, Uint8Array.from(payload)))).toThrow("neither a PNG nor a JPEG");
  });
});

describe("geometry", () => {
  test("arrays in their order", () => {
    const message = frameBytes({ kind: 2 }, geometryPayload(batch, [positions, normals, scalars, indices]));
    expect(decodeGeometry(message)).toEqual({
      layer: "iso",
      lines: false,
      points: false,
      positions,
      normals,
      scalars,
      indices,
      scale: {
        map: "viridis",
        range: [0.5, 2],
        points: batch.scale.points,
        reverse: true,
        log: true,
        steps: 4,
        nan: "#808080",
        below: "#ff0000",
        above: null,
      },
      color: [0.5, 0.5, 0.5, 1],
      lit: true,
      width: 1,
      clip: [],
      origin: [1e6, 0, 0],
    });
  });

  test("arrays that are absent take no room", () => {
    const lines = { ...batch, kind: "lines", indices: 2, normals: false, scalars: false };
    const decoded = decodeGeometry(frameBytes({ kind: 2 }, geometryPayload(lines, [positions, Uint32Array.of(0, 2)])));
    expect(decoded).toMatchObject({ lines: true, normals: null, scalars: null, indices: Uint32Array.of(0, 2) });
  });

  test("lines become the ends of rectangles", () => {
    const lines = {
      ...batch,
      kind: "lines",
      indices: 2,
      normals: false,
      scalars: true,
      width: 2.5,
      clip: [[1, 0, 0, 0.5]],
    };
    const payload = geometryPayload(lines, [positions, scalars, Uint32Array.of(1, 2)]);
    const decoded = decodeGeometry(frameBytes({ kind: 2 }, payload));
    expect(decoded).toMatchObject({ width: 2.5, clip: [[1, 0, 0, 0.5]] });
    expect(decoded && lineEnds(decoded)).toEqual(Float32Array.of(1, 0, 0, 1, 0, 1, 0, 2));
  });

  test("a frame without polygons", () => {
    expect(decodeGeometry(frameBytes({ kind: 2 }, geometryPayload({ batches: 0 }, [])))).toBeNull();
  });

  const whole = geometryPayload(batch, [positions, normals, scalars, indices]);
  const longJson = whole.slice();
  new DataView(longJson.buffer).setUint32(0, 4 * whole.length, true);
  const oddJson = whole.slice();
  new DataView(oddJson.buffer).setUint32(0, 5, true);
  test.each([
    { name: "no room for its description's length", payload: new Uint8Array(2), error: "cut off" },
    { name: "a description longer than itself", payload: longJson, error: "description is cut off" },
    { name: "a description of odd length", payload: oddJson, error: "description is cut off" },
    { name: "an array too few", payload: geometryPayload(batch, [positions, normals, indices]), error: "announced" },
    { name: "four bytes too many", payload: Uint8Array.of(...whole, 0, 0, 0, 0), error: "announced" },
    { name: "no JSON", payload: Uint8Array.of(4, 0, 0, 0, 0x21, 0x21, 0x21, 0x21), error: "JSON" },
  ])("refuses a batch with $name", ({ payload, error }) => {
    expect(() => decodeGeometry(frameBytes({ kind: 2 }, payload))).toThrow(error);
  });
});
