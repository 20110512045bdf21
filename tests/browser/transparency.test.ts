// Tests that transparent polygons drawn by the page look like the server's pictures.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference, meanDistance, type Picture } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

type Layers = Record<string, Record<string, unknown>>;
type Place = [number, number, number];

const nested: Layers = {
  outer: { type: "iso", array: "U:magnitude", values: [12], color: { solid: "#e08040" }, opacity: 0.5 },
  inner: { type: "iso", array: "U:magnitude", values: [17], color: { solid: "#4080e0" }, opacity: 0.5 },
  slice: { type: "slice", axis: "z", value: 2.4, color: { array: "U:magnitude" }, opacity: 0.5 },
};
const boundary = { type: "surface", color: { solid: "#60a0a0" }, opacity: 0.3 };
/**
 * Window sizes. Transparent polygons take seconds per picture in software. Soft edges are compared at the largest size,
 * where they cover the smallest share. Polygons are compared with polygons at the smallest.
 */
const smallest = { width: 480, height: 320 };
const small = { width: 760, height: 480 };
const large = { width: 1000, height: 640 };
const yellow = { color: { solid: "#ffd040" } };
const above: Place = [6, 20, 9];

const sceneOf = (layers: Layers, position = above): object => ({
  dataset: nameOf(data[0] ?? ""),
  background: "#202830",
  camera: { position, target: [5, 0, 2.4], up: [0, 1, 0] },
  layers,
});

/** Runs in the page: counts the WebGL objects that are created. */
function countObjects(): void {
  const page = globalThis as unknown as { objects: number };
  page.objects = 0;
  const gl = WebGL2RenderingContext.prototype as unknown as Record<string, (...values: unknown[]) => unknown>;
  for (const name of ["createTexture", "createFramebuffer", "createBuffer", "createQuery", "texStorage2D"]) {
    const plain = gl[name];
    gl[name] = function (...values) {
      page.objects += 1;
      return plain?.apply(this, values);
    };
  }
}

describe("transparency", { skip }, () => {
  const stage = new Stage({}, { samples: 4 });
  let client: Client;
  before(async () => {
    const options = { ...small, before: `(${countObjects.toString()})()` };
    client = await stage.fresh(options, fragmentOf(sceneOf(nested)));
  });

  const stream = async (name: string): Promise<void> => {
    await client.page.getByLabel("Stream", { exact: true }).selectOption(name);
    await client.settled(name);
  };
  const show = async (scene: object): Promise<void> => {
    await client.taken(() => client.page.evaluate((hash) => void (location.hash = hash), fragmentOf(scene)));
  };
  /** Shows the scene as pictures, because polygons take seconds in software. */
  const showPicture = async (scene: object, size = small): Promise<void> => {
    await stream("image");
    await client.page.setViewportSize(size);
    await show(scene);
  };
  const showPolygons = async (scene: object): Promise<void> => {
    await show(scene);
    await client.page.waitForTimeout(400); // no revision to wait for: unchanged polygons are not sent again
    await client.settled("geometry");
  };
  /** Returns the picture once it no longer changes. While something moves, polygons are drawn in lower quality. */
  const atRest = async (): Promise<Picture> => {
    let last = await client.picture();
    for (let i = 0; i < 60; i += 1) {
      await client.page.waitForTimeout(500);
      const next = await client.picture();
      if (next.width === last.width && meanDistance(next, last) === 0) return next;
      last = next;
    }
    throw new Error("the picture does not come to rest");
  };
  /**
   * Compares both streams. At most the share `most` of the pixels may differ visibly, and the mean difference must be
   * below 1 of 255.
   */
  const alike = async (name: string, most: number): Promise<Picture> => {
    await stream("image");
    const image = await client.picture();
    await client.keep(`transparent-${name}-image`);
    await stream("geometry");
    const polygons = await atRest();
    await client.keep(`transparent-${name}-geometry`);
    const [mean, share] = [meanDistance(image, polygons), difference(image, polygons)];
    assert.ok(mean < 1 && share < most, `${name}: the streams differ by ${mean} in the mean, ${share} of the pixels`);
    return polygons;
  };

  const sides: Record<string, Place> = { front: [5, 0, 26], above, behind: [14, -9, -15] };
  for (const [side, position] of Object.entries(sides)) {
    test(`two nested surfaces and a slice through them from ${side}`, async () => {
      await showPicture(sceneOf(nested, position));
      await alike(side, 0.002);
    });
  }

  const scenes: Record<string, Layers> = {
    "a surface with edges in another": {
      cylinder: { ...boundary, groups: ["cylinder"], opacity: 0.5, edges: { width: 3, color: "#ffffff" } },
      inner: nested.inner ?? {},
    },
    "opaque lines and points before and behind surfaces": {
      boundary,
      lines: { type: "edges", angle: 30, width: 3, ...yellow },
      dots: { type: "points", size: 7, most: 500, ...yellow },
      inner: nested.inner ?? {},
    },
    "lines and points to see through": {
      boundary,
      lines: { type: "edges", angle: 30, width: 4, opacity: 0.5, ...yellow },
      dots: { type: "points", size: 7, most: 500, opacity: 0.5, ...yellow },
      inner: nested.inner ?? {},
    },
    "what is cut off and what is opaque": {
      outer: nested.outer ?? {},
      inner: { ...nested.inner, opacity: 1 },
      cut: { type: "clip", axis: "y", value: 0.1 },
    },
  };
  for (const [name, layers] of Object.entries(scenes)) {
    test(name, async () => {
      await showPicture(sceneOf(layers), large);
      await alike(name.replaceAll(" ", "-"), 0.01);
    });
  }

  test("the order of the layers does not show, nor does which of two surfaces in one place is drawn first", async () => {
    await showPicture(sceneOf(nested), smallest);
    await stream("geometry");
    const twice = { ...nested.outer, color: { solid: "#40e080" } };
    const layers = (order: number): Layers => ({
      ...nested,
      outer: { ...nested.outer, order },
      twice: { ...twice, order: 3 },
    });
    await showPolygons(sceneOf(layers(1)));
    const first = await atRest();
    await showPolygons(sceneOf(layers(9)));
    assert.equal(meanDistance(first, await atRest()), 0);
    await showPolygons(sceneOf(nested));
    const once = await atRest();
    assert.ok(difference(first, once) > 0.1, "each of two in one place takes its share of the light");
  });

  test("it stays right when the window changes and when the context is lost; a drag makes no GL objects", async () => {
    await stream("image");
    await client.page.setViewportSize({ width: 560, height: 440 });
    const whole = await alike("resized", 0.002);
    await client.page.evaluate(() => {
      const canvas = document.querySelectorAll("canvas")[1];
      const lose = canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context");
      lose?.loseContext();
      setTimeout(() => lose?.restoreContext(), 200);
    });
    await client.page.waitForTimeout(500);
    assert.equal(meanDistance(whole, await atRest()), 0);
    const objects = (): Promise<number> =>
      client.page.evaluate(() => (globalThis as unknown as { objects: number }).objects);
    const made = await objects();
    await client.dragCanvas([0.4, 0.5], [0.5, 0.6], 2);
    assert.ok(difference(whole, await atRest()) > 0.05);
    assert.equal(await objects(), made);
    assert.ok(made > 20, "they are counted");
    assert.deepEqual(client.problems, []);
  });
});
