// Tests the order of layers and legends, and that overlays of the canvas do not overlap.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

interface Box {
  what: string;
  left: number;
  top: number;
  right: number;
  bottom: number;
}

describe("the arrangement of layers and legends", { skip }, () => {
  const stage = new Stage();

  async function scene(client: Client): Promise<{ dataset: string; array: string }> {
    const array = await client.page.getByLabel("Array of the iso-surface").first().inputValue();
    return { dataset: nameOf(data[0] ?? ""), array };
  }

  /** Opens a page with three slices of one array, each with its own color map, and all annotations. */
  async function crowded(width: number, height: number): Promise<Client> {
    const first = await stage.fresh();
    const { dataset, array } = await scene(first);
    await first.close();
    const slice = (axis: string, map: string): object => ({ type: "slice", axis, value: 0.5, color: { array, map } });
    const layers = {
      a: slice("x", "viridis"),
      b: slice("y", "magma"),
      c: slice("z", "plasma"),
      o: { type: "outline" },
    };
    const annotations = { axes: true, time: true, dataset: true, title: "A title of several words" };
    return stage.fresh({ width, height }, fragmentOf({ dataset, layers, annotations }));
  }

  const names = (client: Client): Promise<string[]> => client.page.locator(".layer-row").allTextContents();
  const legends = (client: Client): Promise<string[]> =>
    client.page
      .locator(".legend")
      .evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")?.split(", ")[1] ?? ""));

  test("layers are moved by keys, buttons and a drag, and the legends with them; each is one step of undo", async () => {
    const client = await crowded(1280, 900);
    await client.page.getByRole("button", { name: "Layers", exact: true }).click();
    const [x = "", y = "", z = "", outline = ""] = await names(client);
    assert.deepEqual([x, y, z, outline], ["Slice at x = 0.5", "Slice at y = 0.5", "Slice at z = 0.5", "Outline"]);
    assert.deepEqual(await legends(client), [x, y, z], "three of one array are told apart");
    const picture = await client.picture();
    await client.page.getByRole("button", { name: "Move this layer down" }).first().focus();
    await client.page.keyboard.press("Enter");
    assert.deepEqual(await names(client), [y, x, z, outline]);
    await client.page.keyboard.press("Enter");
    assert.deepEqual(await names(client), [y, z, x, outline], "the focus has moved with the row");
    assert.deepEqual(await legends(client), [y, z, x]);
    const rows = client.page.locator(".layer-row");
    await rows.nth(3).dragTo(rows.nth(0), { targetPosition: { x: 60, y: 4 } });
    assert.deepEqual(await names(client), [outline, y, z, x]);
    await client.settled();
    await client.button("Undo").click();
    await client.settled();
    assert.deepEqual(await names(client), [y, z, x, outline]);
    await client.button("Undo").click();
    await client.button("Undo").click();
    await client.settled();
    assert.deepEqual(await names(client), [x, y, z, outline]);
    await client.button("Redo").click();
    await client.settled();
    assert.deepEqual(await legends(client), [y, x, z]);
    assert.ok(difference(picture, await client.picture()) < 0.002, "surfaces that cross look the same in any order");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  async function boxes(client: Client): Promise<Box[]> {
    const boxesOf = (seen: string): Promise<Box[]> =>
      client.page.locator(seen).evaluateAll((all) =>
        all.map((element) => {
          const { left, top, right, bottom } = element.getBoundingClientRect();
          const what = element.getAttribute("aria-label") ?? element.textContent;
          return { what: what.slice(0, 30), left, top, right, bottom };
        }),
      );
    const legends = await boxesOf(".legend");
    const isCaption = ({ what }: Box): boolean =>
      what === "A title of several words" || what === nameOf(data[0] ?? "") || what.startsWith("Time: ");
    const captions = (await boxesOf(".texts text")).filter(isCaption);
    return [...captions, ...legends, ...(await boxesOf(".triad, .box-axes text"))];
  }

  for (const [width, height] of [
    [320, 480],
    [420, 700],
    [700, 400],
    [1280, 800],
  ] as const)
    test(`nothing over the canvas lies on anything else at ${width} x ${height}`, async () => {
      const client = await crowded(width, height);
      await client.page.waitForTimeout(300);
      await client.keep(`arrangement_${width}`);
      const all = await boxes(client);
      assert.ok(all.some(({ what }) => what === "A title of several words"));
      assert.ok(all.length >= (width < 400 ? 3 : 8), `${all.length} are seen`);
      const meet = (a: Box, b: Box): boolean =>
        Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
        Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 4; // a text box is 4 pixels higher than its letters
      for (const [i, a] of all.entries())
        for (const b of all.slice(0, i)) assert.ok(!meet(a, b), `${a.what} lies on ${b.what}`);
      assert.deepEqual(client.problems, []);
      await client.close();
    });
});
