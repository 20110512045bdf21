import { describe, expect, test } from "vitest";
import { GeometryDecoder, type GeometryBatch } from "../src/server/geometry";
import { pictureOf } from "../src/server/image";
import { lineEnds } from "../src/view/lines";
import { readFrameHeader } from "../src/generated/frame_header";
import { frameBytes, geometryPayload, PNG_SIGNATURE } from "./frames";
import { sequenceStream, triangleStream, vertexStream } from "./geometry_frames";

const records = new DataView(new ArrayBuffer(3 * 16));
[
  [0, 0, 0, 0, 0],
  [4, 0, 0, 127, 0],
  [0, 4, 2, -127, -127],
].forEach(([x = 0, y = 0, z = 0, nx = 0, ny = 0], i) => {
  [x, y, z].forEach((place, axis) => records.setUint32(16 * i + 4 * axis, place, true));
  records.setInt8(16 * i + 12, nx);
  records.setInt8(16 * i + 13, ny);
});
const vertices = vertexStream(records, 3, 16);
const corners = triangleStream(Uint32Array.of(0, 1, 2));
const places = vertexStream(Uint32Array.of(0, 2, 0xffffffff), 3, 4);
const batch = {
  layer: "iso",
  kind: "triangles",
  vertices: 3,
  indices: 3,
  normals: true,
  mesh: { id: "a1", step: 0.25, low: [-4, 0, 8], bytes: [vertices.length, corners.length] },
  values: { id: "b2", of: "vertices", step: 0.5, origin: 0.5, low: -1, bytes: places.length },
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
  base: 0,
};
const positions = Float32Array.of(-1, 0, 2, 0, 0, 2, -1, 1, 2.5);
const normals = Float32Array.of(0, 0, 1, 1, 0, 0, 0, 0, -1);
const scalars = Float32Array.of(0, 1, NaN);
const indices = Uint32Array.of(0, 1, 2);
const frameOf = (payload: Uint8Array, frame = 1): ArrayBuffer => frameBytes({ kind: 2, frame }, payload);
const decodeGeometry = (message: ArrayBuffer): GeometryBatch | null => new GeometryDecoder().decode(message);

describe("frame header", () => {
  test("every field at its offset", () => {
    const message = frameBytes(
      { kind: 1, flags: 5, view: 7, frame: 9, revision: 2n ** 40n, time: 0.125, triangles: 1234 },
      PNG_SIGNATURE,
    );
    expect(readFrameHeader(message)).toEqual({
      kind: 1,
      flags: 5,
      still: true,
      lastOfFrame: false,
      firstOfFrame: true,
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
    { name: "short", message: new ArrayBuffer(79), error: "has 79 bytes; its header alone has 80" },
    { name: "foreign", message: changed(0, 0x58), error: "does not begin with 'CIEL'" },
    {
      name: "another version",
      message: changed(4, 1),
      error: "version 1; this program reads version 2. Reload the page",
    },
    {
      name: "cut off",
      message: frameBytes({}, PNG_SIGNATURE).slice(0, 85),
      error: "announces 8 bytes after its header and has 5",
    },
    { name: "too long", message: changed(60, 7), error: "announces 7 bytes after its header and has 8" },
    {
      name: "behind its whole",
      message: changed(68, 1),
      error: "has 8 bytes at offset 1, but the whole frame has only 8",
    },
  ])("refuses a message that is $name", ({ message, error }) => {
    expect(() => readFrameHeader(message)).toThrow(error);
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
  test("places on the grid, normals on the octahedron, values in steps", () => {
    const decoded = decodeGeometry(frameOf(geometryPayload(batch, [vertices, corners, places])));
    const { normals: decodedNormals, ...others } = decoded ?? { normals: null };
    decodedNormals?.forEach((component, i) => expect(component).toBeCloseTo(normals[i] ?? NaN, 6));
    expect(others).toEqual({
      layer: "iso",
      lines: false,
      points: false,
      positions,
      scalars: scalars.map((value) => value - 0.5), // no rounding: all numbers are multiples of 0.5
      scalarOrigin: 0.5,
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

  const bare = vertexStream(Uint32Array.of(0, 0, 0, 4, 0, 0, 0, 4, 2), 3, 12);
  const withoutNormals = (kind: string, ofIndices: Uint8Array, rest: object): object => {
    const mesh = { ...batch.mesh, bytes: [bare.length, ofIndices.length] };
    return { ...batch, kind, normals: false, mesh, ...rest };
  };

  test("lines become the ends of rectangles, with values as floats", () => {
    const ends = sequenceStream(Uint32Array.of(1, 2));
    const values = vertexStream(Float32Array.of(0, 1, 2), 3, 4);
    const lines = withoutNormals("lines", ends, {
      indices: 2,
      values: { id: "c3", of: "vertices", bytes: values.length },
      width: 2.5,
      clip: [[1, 0, 0, 0.5]],
    });
    const decoded = decodeGeometry(frameOf(geometryPayload(lines, [bare, ends, values])));
    expect(decoded).toMatchObject({ lines: true, width: 2.5, clip: [[1, 0, 0, 0.5]], normals: null });
    expect(decoded && lineEnds(decoded)).toEqual(Float32Array.of(0, 0, 2, 1, -1, 1, 2.5, 2));
  });

  test("values of triangles give each a vertex of its own", () => {
    const two = triangleStream(Uint32Array.of(0, 1, 2, 2, 1, 0));
    const values = vertexStream(Float32Array.of(5, 7), 2, 4);
    const triangles = withoutNormals("triangles", two, {
      indices: 6,
      values: { id: "d4", of: "triangles", bytes: values.length },
    });
    const decoded = decodeGeometry(frameOf(geometryPayload(triangles, [bare, two, values])));
    expect(decoded).toMatchObject({
      scalars: Float32Array.of(5, 5, 5, 7, 7, 7),
      indices: Uint32Array.of(0, 1, 2, 3, 4, 5),
    });
    expect(decoded?.positions.length).toBe(18);
  });

  test("values of a small range far from zero keep their digits", () => {
    const far = 101325;
    const values = { ...batch.values, step: 2 ** -20, origin: far, low: 3 };
    const decoded = decodeGeometry(frameOf(geometryPayload({ ...batch, values }, [vertices, corners, places])));
    expect(decoded?.scalarOrigin).toBe(far);
    expect(decoded?.scalars?.[0]).toBe(2 ** -20 * 3);
  });

  const meshKept = { ...batch.mesh, bytes: undefined }; // undefined stands for a member that is absent in the JSON
  const valuesKept = { ...batch.values, bytes: undefined };
  const whole = geometryPayload(batch, [vertices, corners, places]);

  test("what came before is named, with the same arrays and other colors", () => {
    const decoder = new GeometryDecoder();
    const first = decoder.decode(frameOf(whole, 1));
    const later = { ...batch, mesh: meshKept, values: valuesKept, color: [1, 0, 0, 1], base: 1 };
    const second = decoder.decode(frameOf(geometryPayload(later, []), 2));
    expect(second?.positions).toBe(first?.positions);
    expect(second?.scalars).toBe(first?.scalars);
    expect(second?.color).toEqual([1, 0, 0, 1]);
    const otherValues = { ...batch, mesh: meshKept, values: { ...batch.values, id: "e5" }, base: 1 };
    const third = decoder.decode(frameOf(geometryPayload(otherValues, [places]), 3));
    expect(third?.positions).toBe(first?.positions);
  });

  test("what no frame from the base on has is forgotten", () => {
    const decoder = new GeometryDecoder();
    decoder.decode(frameOf(whole, 1));
    decoder.decode(frameOf(geometryPayload({ batches: 0, base: 2 }, []), 3));
    const named = geometryPayload({ ...batch, mesh: meshKept, values: valuesKept, base: 2 }, []);
    expect(() => decoder.decode(frameOf(named, 4))).toThrow("The arrays a1 of a geometry frame are missing");
  });

  test("a frame without polygons", () => {
    expect(decodeGeometry(frameOf(geometryPayload({ batches: 0, base: 0 }, [])))).toBeNull();
  });

  const longJson = whole.slice();
  new DataView(longJson.buffer).setUint32(0, 4 * whole.length, true);
  test.each([
    { name: "no room for its description's length", payload: new Uint8Array(2), error: "cut off" },
    { name: "a description longer than itself", payload: longJson, error: "description is cut off" },
    { name: "an array too few", payload: geometryPayload(batch, [vertices, corners]), error: "arrays are too short" },
    { name: "four bytes too many", payload: Uint8Array.of(...whole, 0, 0, 0, 0), error: "4 bytes too long" },
    {
      name: "a damaged array",
      payload: geometryPayload(batch, [vertices.map(() => 9), corners, places]),
      error: "Malformed",
    },
    { name: "no JSON", payload: Uint8Array.of(4, 0, 0, 0, 0x21, 0x21, 0x21, 0x21), error: "JSON" },
  ])("refuses a batch with $name", ({ payload, error }) => {
    expect(() => decodeGeometry(frameOf(payload))).toThrow(error);
  });
});
