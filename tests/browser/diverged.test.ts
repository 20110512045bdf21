// Tests a dataset with a non-finite value in one cell. Only this cell is missing in both streams, and the page tells
// the number of such cells. Legend, probe and array table show the extremes of the cells.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { distance } from "./png.ts";
import { CELLS, rowIn } from "./row.ts";
import { Server } from "./server.ts";
import { skip, Stage } from "./stage.ts";

describe("a cell that blew up", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-diverged-"));
  let server: Server;
  before(async () => {
    server = await Server.started([rowIn(folder, ["0", "nan", "63.6", "3"])]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  const open = async (array: string, stream: string): Promise<Client> => {
    const layer = { type: "slice", axis: "z", value: 0.5, color: { array, map: "viridis", range: [0, 3] } };
    const scene = {
      dataset: "row",
      background: "#000000",
      camera: { position: [2, 0.5, 12], target: [2, 0.5, 0.5], up: [0, 1, 0] },
      layers: { s: layer },
    };
    const client = await stage.open(server.address + fragmentOf(scene), { width: 1280, height: 800 });
    if (stream === "geometry") await client.page.getByLabel("Stream", { exact: true }).selectOption("geometry");
    await client.settled(stream);
    return client;
  };
  const isThere = async (client: Client): Promise<boolean[]> => {
    const picture = await client.picture();
    const scale = picture.height / 2 / (11.5 * Math.tan((15 * Math.PI) / 180));
    return Array.from({ length: CELLS }, (_, cell) => {
      const x = Math.round(picture.width / 2 + (cell + 0.5 - 2) * scale);
      return distance(picture.at(x, Math.round(picture.height / 2)), [0, 0, 0]) > 20;
    });
  };

  for (const array of ["q", "cell:q"])
    for (const stream of ["image", "geometry"])
      test(`is missing alone: ${array} as ${stream}`, async () => {
        const client = await open(array, stream);
        assert.deepEqual(await isThere(client), [true, false, true, true]);
        await client.page.getByText(`1 cell has no number for ${array} at this time and is left out`).first().waitFor();
        await client.keep(`diverged-${array.replace(":", "-")}-${stream}`);
        assert.deepEqual(client.problems, []);
        await client.close();
      });

  test("the legend, the probe and the table of arrays tell the extremes", async () => {
    const client = await open("q", "image");
    await client.page.locator(".texts text", { hasText: "cells: 0 to 63.6" }).waitFor();
    const title = await client.page.getByLabel("Colors of q").getAttribute("title");
    assert.match(
      title ?? "",
      /^q.*\. Lowest 0 in cell 0 at \(0\.5, 0\.5, 0\.5\); highest 63\.6 in cell 2 at \(2\.5, 0\.5, 0\.5\)$/,
    );
    const box = await client.canvas.boundingBox();
    await client.canvas.click({ position: { x: (box?.width ?? 0) / 2 + 30, y: (box?.height ?? 0) / 2 } });
    await client.page.locator(".probe", { hasText: "highest 63.6 in cell 2" }).waitFor();
    await client.page.getByRole("button", { name: "Dataset", exact: true }).click();
    await client.page.locator(".array-facts", { hasText: "interpolated from cells" }).first().waitFor();
    await client.keep("diverged-extremes");
    await client.close();
  });
});
