// The layers' controls: each changes what both streams show.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { skip, Stage } from "./stage.ts";

describe("layers", { skip }, () => {
  const stage = new Stage({ width: 1280, height: 720 });
  let client: Client;
  before(async () => {
    client = await stage.same();
  });

  const check = (section: string, label: string): ReturnType<Client["page"]["getByLabel"]> =>
    client.page
      .locator("section.section", { has: client.page.getByRole("heading", { name: section }) })
      .getByLabel(label, { exact: true })
      .first();
  const stream = async (name: string): Promise<void> => {
    await client.page.getByLabel("Stream", { exact: true }).selectOption(name);
    await client.settled(name);
  };
  /** Both streams show the scene alike but for how smooth their edges are. */
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
    assert.ok(difference(plain, edged) > 0.003);
    await alike("edges");
    await check("Iso-surfaces", "Width of the edges in pixels").fill("4");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(difference(edged, await client.picture()) > 0.003, "wider edges hide more");
    await check("Iso-surfaces", "Cell edges").uncheck();
    await client.settled();
    assert.ok(difference(plain, await client.picture()) < 0.001);
  });

  test("contour lines of a slice", async () => {
    await check("Slices", "Z").check();
    await client.settled();
    const plain = await client.picture();
    await check("Slices", "Contour lines").check();
    await client.settled();
    const lined = await client.picture();
    assert.ok(difference(plain, lined) > 0.002);
    await alike("contours");
    await check("Slices", "Number of contour lines").fill("30");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(difference(lined, await client.picture()) > 0.002, "more lines");
    await check("Slices", "Contour lines").uncheck();
    await client.settled();
    assert.ok(difference(plain, await client.picture()) < 0.001);
    await check("Slices", "Z").uncheck();
    await client.settled();
  });
});
