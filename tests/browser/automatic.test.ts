// Tests the automatic choice of the stream for different lines, gestures and scenes. A fake graphics card draws nothing
// and takes no time, so the speed of this machine has no influence.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { cubeIn } from "./cube.ts";
import { Line, type LineOptions } from "./line.ts";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { datasets, Server } from "./server.ts";
import { data, isoFragment, skip, Stage } from "./stage.ts";

/**
 * Runs in the page: fakes a graphics card. `slowness`: milliseconds by which each drawing delays the next animation
 * frame.
 */
function pretendCard(slowness: number): void {
  const UNMASKED_RENDERER = 0x9246;
  const context = WebGL2RenderingContext.prototype;
  const plain = Reflect.get(context, "getParameter") as (name: number) => unknown;
  context.getParameter = function (name) {
    return name === UNMASKED_RENDERER ? "ANGLE (NVIDIA, GeForce)" : plain.call(this, name);
  };
  context.drawElements = context.drawArrays = (): void => undefined;
  window.requestAnimationFrame = (callback) => window.setTimeout(() => callback(performance.now()), slowness);
}

const card = (slowness = 0): string => `(${pretendCard.toString()})(${slowness});`;

const CUBE = fragmentOf({
  dataset: "cube",
  layers: { iso: { type: "iso", array: "x", values: [0.5] } },
});

describe("the automatic stream", { skip }, () => {
  const stage = new Stage({}, { large: true }); // the large dataset's polygons take long on a slow line
  const folder = mkdtempSync(join(tmpdir(), "ciel-automatic-"));
  let server: Server;
  before(async () => {
    server = await Server.started([datasets("CIEL_BROWSER_LARGE")[0] ?? data[0] ?? "", cubeIn(folder)]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  async function over(
    options: LineOptions,
    fragment: string,
    browser: string,
    use: (client: Client) => Promise<void>,
  ): Promise<void> {
    const line = await Line.to(server.port, options);
    const client = await stage.open(`http://127.0.0.1:${line.port}/${fragment}`, { before: browser });
    try {
      await client.connected();
      await use(client);
      assert.deepEqual(client.problems, []);
    } finally {
      await client.close();
      await line.close();
    }
  }

  const said = (client: Client): Promise<string> =>
    client.page
      .locator("[data-readout=stream-why]")
      .first()
      .textContent()
      .then((text) => text ?? "");
  const says = (client: Client, text: RegExp): Promise<void> =>
    client.page.locator("[data-readout=stream-why]", { hasText: text }).first().waitFor();

  /** Drags the iso-value or the view until the page gives a reason that matches `text` and shows frames of `stream`. */
  async function moveUntil(client: Client, what: "value" | "view", text: RegExp, stream: string): Promise<void> {
    const place = await (what === "view" ? client.canvas : client.isoValue).boundingBox();
    assert.ok(place !== null);
    const [x, y] = [place.x + place.width / 2, place.y + place.height / 2];
    await client.page.mouse.move(x, y);
    await client.page.mouse.down();
    const isSo = async (): Promise<boolean> =>
      text.test(await said(client)) && (await client.page.locator(`[data-frame][data-stream=${stream}]`).count()) > 0;
    const deadline = Date.now() + 120_000;
    for (let step = 1; !(await isSo()); step += 1) {
      if (Date.now() > deadline) throw new Error(`not ${String(text)}, but: ${await said(client)}`);
      await client.page.mouse.move(x + 20 * Math.sin(step / 4), y);
    }
    await client.page.mouse.up();
  }

  test("dear polygons over a slow line: pictures while a value moves, polygons at rest and for the camera", async () => {
    await over({ rate: 1.5 }, await isoFragment(server), card(), async (client) => {
      await says(client, /^Polygons: the polygons \(.* MB\) arrive in .* s at .*B\/s/);
      await client.settled("geometry");
      await moveUntil(client, "view", /^Polygons: the view turns without a picture from the server\.$/, "geometry");
      await client.settled("geometry");
      await moveUntil(client, "value", /^Pictures: a change takes .* with polygons \(.* MB at .*B\/s\)/, "image");
      await says(client, /^Polygons: the polygons/);
      await client.settled("geometry");
    });
  });

  test("dearer than a pause allows: pictures only", async () => {
    await over({ rate: 0.5 }, await isoFragment(server), card(), async (client) => {
      await says(client, /^Pictures: the polygons \(.* MB\) arrive in .* s at .*B\/s\.$/);
      await client.settled();
      await moveUntil(client, "view", /^Pictures: the polygons/, "image");
      await client.settled();
    });
  });

  test("few polygons over a slow line: polygons for the value and for the camera", async () => {
    await over({ rate: 0.5 }, CUBE, card(), async (client) => {
      await client.settled("geometry");
      await moveUntil(client, "value", /^Polygons: (a change takes|the polygons are) .*B/, "geometry");
      await client.settled("geometry");
      await moveUntil(client, "view", /^Polygons: the /, "geometry");
      await client.settled("geometry");
    });
  });

  test("a browser that draws too slowly gets pictures", async () => {
    await over({}, CUBE, card(1000), async (client) => {
      await client.settled("geometry");
      await moveUntil(client, "view", /^Pictures: this browser needs .* s to draw the polygons/, "image");
      await client.settled();
    });
  });

  test("a browser without a graphics card gets pictures", async () => {
    await over({ rate: 100 }, CUBE, "", async (client) => {
      await client.settled();
      assert.equal(await said(client), "Pictures: this browser draws without a graphics card.");
    });
  });
});
