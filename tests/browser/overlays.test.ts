// Tests that overlays of the canvas match the shown picture: while it is older than the scene, and when a script
// removes the camera.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { skip, Stage } from "./stage.ts";

describe("what lies over the picture", { skip }, () => {
  const stage = new Stage();

  async function call(method: string, params: object): Promise<unknown> {
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method, params });
    const headers = { "Content-Type": "application/json" };
    const response = await fetch(new URL("rpc", stage.server.address), { method: "POST", headers, body });
    const { result, error } = (await response.json()) as { result: unknown; error: unknown };
    assert.equal(error, undefined, JSON.stringify(error));
    return result;
  }

  const lines = (client: Client): Promise<number[]> =>
    client.page
      .locator(".box-axes > line")
      .evaluateAll((all) =>
        all.flatMap((line) => ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)))),
      );

  test("axes wait for the picture that they belong to", async () => {
    const client = await stage.fresh({ width: 1100, height: 700 });
    await client.page.getByRole("checkbox", { name: "Axes of the box" }).check();
    await client.settled();
    const before = await lines(client);
    assert.ok(before.length >= 8);
    stage.server.pause();
    try {
      await client.dragCanvas([0.4, 0.5], [0.7, 0.6]);
      await client.page.waitForTimeout(300);
      assert.deepEqual(await lines(client), before, "no picture has come");
    } finally {
      stage.server.goOn();
    }
    await client.settled();
    const after = await lines(client);
    assert.ok(after.length > 0 && after.some((place, i) => Math.abs(place - (before[i] ?? 0)) > 5), "it has");
    await client.button("Undo").click();
    await client.settled();
    assert.deepEqual(await lines(client), before);
    await client.close();
  });

  test("a scene without a camera has its axes where the server sees the box, and is turned from there", async () => {
    const client = await stage.fresh({ width: 1100, height: 700 });
    const session = (await client.page.evaluate(() => sessionStorage.getItem("ciel.session"))) ?? "";
    const patch = (change: object): Promise<unknown> => call("scene.patch", { session, patch: change });
    const was = await lines(client);
    await patch({ camera: null, annotations: { axes: true, title: "From a script" } });
    await client.page.locator(".texts text", { hasText: "From a script" }).waitFor();
    await client.settled();
    await client.page.waitForTimeout(500); // time for the page to ask for the camera
    const without = { lines: await lines(client), picture: await client.picture() };
    assert.ok(without.lines.length >= 8 && was.length === 0);
    const box = await client.canvas.boundingBox();
    const size = { width: Math.round(box?.width ?? 0), height: Math.round(box?.height ?? 0) };
    await patch({ camera: await call("scene.camera", { session, ...size }) });
    await client.settled();
    const given = await lines(client);
    without.lines.forEach((place, i) => assert.ok(Math.abs(place - (given[i] ?? NaN)) < 0.5, `${place} ${given[i]}`));
    assert.ok(difference(without.picture, await client.picture()) < 0.001);
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
