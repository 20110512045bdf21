// Tests that the focus stays in a list when its items are removed by keys.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";
import type { Client } from "./page.ts";

const slice = (axis: string, value: number): object => ({ type: "slice", axis, value, color: { array: "tracer" } });
const layers = {
  a: slice("x", 2),
  b: slice("x", 8),
  c: slice("y", 1),
  clip: { type: "clip", axis: "z", value: 4, visible: false },
  edges: { type: "edges", angle: 30 },
  iso: { type: "iso", array: "tracer", values: [0.2, 0.4, 0.6] },
  points: { type: "points", visible: false },
  volume: { type: "volume", array: "tracer", visible: false },
};
const camera = { position: [20, -25, 15], target: [5, 0, 2], up: [0, 0, 1] };

/** Accessible name of the focused element and of the card that contains it. */
const focused = (client: Client): Promise<string> =>
  client.page.evaluate(() => {
    const { activeElement } = document;
    const card = activeElement?.closest("article")?.getAttribute("aria-label");
    return `${activeElement?.getAttribute("aria-label") ?? activeElement?.tagName ?? ""}${card ? ` of ${card}` : ""}`;
  });

describe("what is taken away by keys", { skip }, () => {
  const stage = new Stage();

  test("leaves the focus on the next of its list, else on the one before, else on what adds one", async () => {
    const scene = fragmentOf({ dataset: nameOf(data[0] ?? ""), camera, layers });
    const client = await stage.fresh({ width: 1280, height: 900 }, scene);
    const remove = async (name: string, place = 0): Promise<string> => {
      await client.button(name, true).nth(place).focus();
      await client.page.keyboard.press("Enter");
      await client.page.waitForTimeout(100);
      return focused(client);
    };
    assert.equal(await remove("Remove this slice", 1), "Remove this slice of Slice at y = 1");
    assert.equal(await remove("Remove this slice", 1), "Remove this slice of Slice at x = 2");
    assert.equal(await remove("Remove this slice"), "Add a slice across x");
    assert.equal(await remove("Remove this clip"), "Add a clip across x");
    assert.equal(await remove("Remove this volume"), "Add a volume");
    assert.equal(await remove("Remove these edges"), "Remove these points of Points");
    assert.equal(await remove("Remove value 3"), "Remove value 2 of Iso-surface of tracer");
    assert.equal(await remove("Remove value 1"), "Add a value of Iso-surface of tracer");
    assert.equal(await remove("Remove this iso-surface"), "Add an iso-surface");
    await client.settled();
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("is one thing for each press of a key, however long it is held", async () => {
    const scene = fragmentOf({ dataset: nameOf(data[0] ?? ""), camera, layers });
    const client = await stage.fresh({ width: 1280, height: 900 }, scene);
    await client.button("Remove this slice").first().focus();
    for (let i = 0; i < 3; i += 1) {
      await client.page.keyboard.down("Enter");
      await client.page.waitForTimeout(100);
    }
    await client.page.keyboard.up("Enter");
    assert.equal(await client.button("Remove this slice").count(), 2);
    await client.close();
  });
});
