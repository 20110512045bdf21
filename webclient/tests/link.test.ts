import { describe, expect, test } from "vitest";
import type { Scene } from "../src/generated/protocol";
import { decodeScene, decodeSession, encodeScene, encodeSession, fromBase64, toBase64Url } from "../src/model/link";

const scene: Scene = {
  dataset: "Zylinder \u00e4\u6f22 & #=?",
  time: 0.125,
  camera: { position: [1 / 3, -2e9, 3], target: [0, 0, 0], up: [0, 0, 1], fov: 30 },
  layers: { iso: { type: "iso", array: "U:magnitude", values: [0.1, 0.2], color: { array: "p", range: [-1, 1] } } },
};

describe("link", () => {
  test("the same scene comes back", async () => {
    const fragment = await encodeScene(scene);
    expect(fragment).toMatch(/^#s=[A-Za-z0-9_-]+$/); // mail programs keep these characters
    expect(await decodeScene(fragment)).toEqual(scene);
  });

  test("another fragment is no scene", async () => {
    expect(await decodeScene("")).toBeNull();
    expect(await decodeScene("#help")).toBeNull();
  });

  test("a damaged one is named", async () => {
    const fragment = await encodeScene(scene);
    const wrong = [fragment.slice(0, -20), "#s=%%%", "#s=", `#s=${toBase64Url(new TextEncoder().encode("[]"))}`];
    for (const damaged of wrong) await expect(decodeScene(damaged)).rejects.toThrow("does not hold a whole scene");
  });

  test("a session's id comes back; what is too short to be a key is none", async () => {
    const id = "0123456789abcdefABCD-_";
    expect(decodeSession(encodeSession(id))).toBe(id);
    expect(await decodeScene(encodeSession(id))).toBeNull();
    for (const other of ["", "#j=", `#j=${id.slice(1)}`, `#j=${id} `, "#j=..%2f..%2f..%2f..%2f..%2f..", `#s=${id}`])
      expect(decodeSession(other)).toBeNull();
  });

  test("base64 of every byte, in both alphabets", () => {
    const bytes = Uint8Array.from({ length: 256 }, (_, i) => i);
    expect(fromBase64(toBase64Url(bytes))).toEqual(bytes);
    expect(fromBase64(btoa(String.fromCharCode(...bytes)))).toEqual(bytes);
  });
});
