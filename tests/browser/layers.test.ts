// Tests that the controls of the layers change the picture in both streams.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import type { Locator } from "./chromium.ts";
import type { Client } from "./page.ts";
import { covered, darker, difference, share } from "./png.ts";
import { skip, Stage } from "./stage.ts";

describe("layers", { skip }, () => {
  const stage = new Stage({ width: 1280, height: 720 });
  let client: Client;
  before(async () => {
    client = await stage.same();
  });

  const section = (title: string): Locator =>
    client.page.locator("section.section", { has: client.page.getByRole("heading", { name: title }) });
  const check = (title: string, label: string): Locator =>
    section(title).getByRole("checkbox", { name: label }).first();
  const field = (title: string, label: string): Locator => section(title).getByRole("textbox", { name: label }).first();
  const stream = async (name: string): Promise<void> => {
    await client.page.getByLabel("Stream", { exact: true }).selectOption(name);
    await client.settled(name);
  };
  /** Checks that both streams show the same scene, except for the smoothness of edges. */
  const alike = async (name: string): Promise<void> => {
    const image = await client.picture();
    await client.keep(`${name}-image`);
    await stream("geometry");
    const geometry = await client.picture();
    await client.keep(`${name}-geometry`);
    await stream("image");
    const differs = difference(image, geometry);
    assert.ok(differs < 0.04, `${name}: the streams differ by ${differs}`);
  };

  test("cell edges of an iso-surface", async () => {
    const plain = await client.picture();
    await check("Iso-surfaces", "Cell edges").check();
    await client.settled();
    const edged = await client.picture();
    assert.ok(darker(plain, edged) > 0.01 && darker(edged, plain) < 0.001, "edges are dark");
    await alike("edges");
    await field("Iso-surfaces", "Width of the edges in pixels").fill("4");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(darker(plain, await client.picture()) > 1.5 * darker(plain, edged), "wider edges hide more");
    await check("Iso-surfaces", "Cell edges").uncheck();
    await client.settled();
    assert.ok(difference(plain, await client.picture()) < 0.001);
  });

  test("contour lines of a slice", async () => {
    await client.button("Add a slice across z").click();
    await client.settled();
    const plain = await client.picture();
    await check("Slices", "Contour lines").check();
    await client.settled();
    const lined = await client.picture();
    assert.ok(darker(plain, lined) > 0.005 && darker(lined, plain) < 0.001, "lines are dark");
    await alike("contours");
    await field("Slices", "Number of contour lines").fill("30");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(darker(plain, await client.picture()) > 1.5 * darker(plain, lined), "more lines");
    await check("Slices", "Contour lines").uncheck();
    await client.settled();
    assert.ok(difference(plain, await client.picture()) < 0.001);
    await client.button("Remove this slice").click();
    await client.settled();
  });

  test("a clip cuts the boundary open, closes it with a cap, and goes away again", async () => {
    await check("Boundary", "Whole boundary").check();
    await client.settled();
    const whole = await client.picture();
    await client.button("Add a clip across x").click();
    await client.settled();
    const cut = await client.picture();
    assert.ok(covered(cut) < covered(whole) - 0.01 && difference(whole, cut) > 0.05, "half of it is gone");
    await alike("clip");
    await check("Clip", "Caps").uncheck();
    await client.settled();
    const open = await client.picture();
    assert.ok(darker(open, cut) > 0.01 && darker(cut, open) < 0.001, "one looks at the light inside");
    assert.ok(Math.abs(covered(open) - covered(cut)) < 0.005, "a cap hides the inside only");
    await check("Clip", "Caps").check();
    await check("Clip", "Other side").check();
    await client.settled();
    const other = await client.picture();
    assert.ok(covered(other) < covered(whole) - 0.01 && difference(cut, other) > 0.1, "the other half");
    await client.button("Remove this clip").click();
    await client.settled();
    assert.ok(difference(whole, await client.picture()) < 0.001);
    await check("Boundary", "Whole boundary").uncheck();
    await client.settled();
  });

  test("lights, which both streams show alike, and ambient occlusion", async () => {
    await check("Boundary", "Whole boundary").check();
    await client.page.getByRole("button", { name: "Lighting" }).click();
    await client.settled();
    const lit = await client.picture();
    await check("Lighting", "Key light").uncheck();
    await client.settled();
    const dim = await client.picture();
    assert.ok(darker(lit, dim) > 0.1 && darker(dim, lit) < 0.001, "the key light is off");
    await alike("headlight");
    await check("Lighting", "Lights").uncheck();
    await client.settled();
    const unlit = await client.picture(); // the colors of the scale, which shading only darkens
    assert.ok(darker(unlit, lit) > 0.1 && darker(lit, unlit) < 0.001, "no light at all");
    await alike("unlit");
    await check("Lighting", "Lights").check();
    await check("Lighting", "Key light").check();
    await client.settled();
    assert.ok(difference(lit, await client.picture()) < 0.001);
    await client.button("Add a clip across x").click();
    await check("Clip", "Caps").uncheck();
    await client.settled();
    const open = await client.picture();
    await check("Lighting", "Ambient occlusion").check();
    await client.settled();
    const occluded = await client.picture();
    assert.ok(difference(open, occluded) > 0.01, "the corners inside differ");
    assert.ok(darker(open, occluded) > 0.004 && darker(occluded, open) < 0.001, "and are darker");
    await client.keep("occlusion");
    await check("Lighting", "Ambient occlusion").uncheck();
    await client.button("Remove this clip").click();
    await check("Boundary", "Whole boundary").uncheck();
    await client.page.getByRole("button", { name: "Lighting" }).click();
    await client.settled();
  });

  test("edges and points of the mesh", async () => {
    const before = await client.picture();
    await client.button("Add edges of the mesh").click();
    await client.settled();
    const edged = await client.picture();
    assert.ok(darker(edged, before) > 0.002 && darker(before, edged) < 0.001, "edges of the mesh are light");
    await client.button("Add points of the mesh").click();
    await client.settled();
    const image = await client.picture();
    assert.ok(darker(image, before) > 0.02 && covered(image) > covered(before) + 0.005, "points lie outside, too");
    await client.keep("points-image");
    await stream("geometry");
    const geometry = await client.picture();
    await client.keep("points-geometry");
    await stream("image");
    // Rims of thousands of small discs differ between the streams, so only the covered area is compared.
    const light = [image, geometry].map((picture) => share(picture, (color) => Math.min(...color) > 185));
    assert.ok(Math.abs((light[0] ?? 0) - (light[1] ?? 1)) < 0.03, `points cover ${light.join(" and ")}`);
    await client.button("Remove these points").click();
    await client.button("Remove these edges").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.001);
  });

  test("a threshold shows the boundary of the cells in the range", async () => {
    await check("Boundary", "Whole boundary").check();
    await client.settled();
    const whole = await client.picture();
    await check("Boundary", "Threshold").check();
    await client.settled();
    const within = await client.picture();
    assert.ok(
      difference(whole, within) > 0.02 && covered(within) < covered(whole) - 0.02,
      "cells out of range are gone",
    );
    await alike("threshold");
    await check("Boundary", "Threshold").uncheck();
    await client.settled();
    assert.ok(difference(whole, await client.picture()) < 0.001);
    assert.deepEqual(client.problems, []);
  });
});
