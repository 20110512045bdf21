// Tests the page over a line with a long round trip to the server.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { Line, type LineOptions } from "./line.ts";
import type { Client } from "./page.ts";
import { isoFragment, skip, Stage } from "./stage.ts";

describe("far from the server", { skip }, () => {
  const stage = new Stage();

  async function over(options: LineOptions, use: (client: Client) => Promise<void>): Promise<void> {
    const line = await Line.to(stage.server.port, options);
    const fragment = await isoFragment(stage.server);
    const client = await stage.open(`http://127.0.0.1:${line.port}/${fragment}`);
    try {
      await client.connected();
      await use(client);
      assert.deepEqual(client.problems, []);
    } finally {
      await client.close();
      await line.close();
    }
  }

  test("no change waits for the answer to the one before, and what is wanted is drawn at once", async () => {
    await over({ roundTrip: 600 }, async (client) => {
      await client.settled();
      let [unanswered, most] = [0, 0];
      client.onPatch({ sent: () => (most = Math.max(most, ++unanswered)), answered: () => (unanswered -= 1) });
      await client.dragIso(0.6); // the page measures the round trip by its first answer
      await client.settled();
      const drag = client.dragIso(0.4, 60);
      await client.page.locator(".ahead text", { hasText: /= / }).waitFor();
      await drag;
      assert.ok(most > 2, `${most} changes were on their way at once`);
      await client.settled();
      assert.equal(await client.page.locator(".ahead").count(), 0);
      const turn = client.dragCanvas([0.4, 0.5], [0.6, 0.5], 60);
      await client.page.locator(".ahead line").first().waitFor({ state: "attached" });
      assert.equal(await client.page.locator(".ahead line").count(), 12);
      await turn;
      await client.settled();
      assert.equal(await client.page.locator(".ahead").count(), 0);
    });
  });
});
