// Tests that cell values are drawn flat in both streams and offered in menus, and that a mesh with one layer of cells
// is first seen from its front.
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

describe("values of cells", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-cells-"));
  let server: Server;
  before(async () => {
    server = await Server.started([rowIn(folder)]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  const camera = {
    position: [2, 0.5, 12],
    target: [2, 0.5, 0.5],
    up: [0, 1, 0],
  };
  const slice = (array: string): object => ({
    type: "slice",
    axis: "z",
    value: 0.5,
    color: { array, map: "grayscale", range: [0, CELLS - 1] },
  });
  const open = async (array: string, stream = "image"): Promise<Client> => {
    const scene = {
      dataset: "row",
      background: "#000000",
      camera,
      layers: { s: slice(array) },
    };
    const client = await stage.open(server.address + fragmentOf(scene), {
      width: 1280,
      height: 800,
    });
    if (stream === "geometry") await client.page.getByLabel("Stream", { exact: true }).selectOption("geometry");
    await client.settled(stream);
    return client;
  };
  /** Gray values along the middle of the bar, near both ends of each cell. */
  const greys = async (client: Client): Promise<number[]> => {
    const picture = await client.picture();
    const scale = picture.height / 2 / (11.5 * Math.tan((15 * Math.PI) / 180));
    const at = (x: number): number => {
      const color = picture.at(Math.round(picture.width / 2 + (x - 2) * scale), Math.round(picture.height / 2));
      assert.ok(distance(color, [color[0], color[0], color[0]]) < 3, `grey at ${x}: ${color.join(" ")}`);
      return color[0];
    };
    return Array.from({ length: CELLS }, (_, cell) => [at(cell + 0.1), at(cell + 0.9)]).flat();
  };

  for (const [stream, what] of [
    ["image", "pictures"],
    ["geometry", "polygons"],
  ] as const)
    test(`are flat in ${what}`, async () => {
      const client = await open("cell:q", stream);
      const found = await greys(client);
      for (let cell = 0; cell < CELLS; cell += 1) {
        const wanted = (255 * cell) / (CELLS - 1);
        for (const grey of [found[2 * cell] ?? NaN, found[2 * cell + 1] ?? NaN])
          assert.ok(Math.abs(grey - wanted) <= 3, `cell ${cell} is ${grey}, not ${wanted}: ${found.join(" ")}`);
      }
      await client.keep(`flat-${stream}`);
      assert.deepEqual(client.problems, []);
      await client.close();
    });

  test("are chosen in the menu", async () => {
    const client = await open("p");
    const smooth = await greys(client);
    assert.ok((smooth[1] ?? 0) - (smooth[0] ?? 0) > 40, "values at points change within a cell");
    await client.page.getByLabel("Color by", { exact: true }).first().selectOption("cell:q");
    await client.settled();
    const flat = await greys(client);
    assert.ok(Math.abs((flat[1] ?? 0) - (flat[0] ?? 0)) <= 2);
    await client.page.locator('.legend[title^="cell:q"]').waitFor();
    await client.close();
  });
});
