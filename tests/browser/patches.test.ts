// Tests a boundary with many patches: search, choice by families, names, and hiding a patch at the cursor.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { barIn } from "./bar.ts";
import type { Locator } from "./chromium.ts";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { Server } from "./server.ts";
import { skip, Stage } from "./stage.ts";

const CELLS = 16;
/**
 * Camera in front of the bar's "front" sides (y = 0), at the middle of cell 8 and above the bar. Through a hole one
 * sees the bottom, which has another brightness.
 */
const camera = { position: [8.5, -20, 13.5], target: [8.5, 0, 0.5], up: [0, 0, 1] } as const;

describe("patches", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-patches-"));
  let server: Server;
  before(async () => {
    server = await Server.started([barIn(folder, CELLS)]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  async function open(surface: object = {}): Promise<Client> {
    const layers = { surface: { type: "surface", ...surface } };
    const client = await stage.open(server.address + fragmentOf({ dataset: "bar", camera, layers }), {
      width: 1280,
      height: 800,
    });
    await client.settled();
    return client;
  }
  const section = (client: Client): Locator => client.page.locator(".section", { hasText: "Boundary" });
  const list = (client: Client): Locator => section(client).locator(".patch-list");
  const groups = async (client: Client): Promise<unknown> => {
    const session = await client.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "scene.get", params: { session } });
    const headers = { "Content-Type": "application/json" };
    await client.settled();
    const answer = await fetch(new URL("rpc", server.address), { method: "POST", headers, body });
    const { result } = (await answer.json()) as {
      result: { scene: { layers: { surface: { visible?: boolean; groups?: string[] } } } };
    };
    const { visible, groups: shown } = result.scene.layers.surface;
    return visible === false ? null : (shown ?? []);
  };

  test("the list has a height of its own, its families are folded, and the looks stand above it", async () => {
    const client = await open();
    const box = await list(client).boundingBox();
    assert.ok((box?.height ?? Infinity) <= 240, `${box?.height} pixels`);
    const looks = await section(client).getByLabel("Color by").boundingBox();
    assert.ok((looks?.y ?? Infinity) < (box?.y ?? 0), "the looks are above the list");
    assert.deepEqual(await list(client).locator(".check span").allTextContents(), [
      "inlet",
      "outlet",
      `bar (${4 * CELLS})`,
    ]);
    await list(client).getByRole("button", { name: "Patches of bar" }).click();
    assert.equal(await list(client).getByRole("checkbox").count(), 3 + 4 * CELLS);
    assert.ok(((await list(client).boundingBox())?.height ?? Infinity) <= 240);
    const room = await client.page.locator(".side-panel").evaluate((panel) => panel.scrollHeight);
    assert.ok(room < 2400, `the panel is ${room} pixels long`);
    await client.keep("patches");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("search, all, none, only and invert", async () => {
    const client = await open({ groups: ["inlet"] });
    const button = (name: string): Promise<void> => section(client).getByRole("button", { name, exact: true }).click();
    const search = section(client).getByRole("searchbox", { name: "Search patches" });
    await search.fill("BACK bar_3");
    assert.deepEqual(await list(client).locator(".patch-row:not(.family) .check span").allTextContents(), ["3-back"]);
    await button("All");
    assert.deepEqual(await groups(client), ["inlet", "bar_3-back"]);
    await button("Invert");
    assert.deepEqual(await groups(client), ["inlet"]);
    await search.press("Escape");
    assert.equal(await search.inputValue(), "");
    await button("Invert");
    const all = (await groups(client)) as string[];
    assert.deepEqual([all.length, all.includes("inlet")], [1 + 4 * CELLS, false]);
    await button("All");
    assert.deepEqual(await groups(client), []);
    await button("None");
    assert.equal(await groups(client), null);
    await button("Only outlet");
    assert.deepEqual(await groups(client), ["outlet"]);
    await button("Only all of bar");
    assert.equal(((await groups(client)) as string[]).length, 4 * CELLS);
    await list(client).getByLabel("All of bar", { exact: true }).uncheck();
    assert.equal(await groups(client), null);
    await client.button("Undo").click();
    assert.equal(((await groups(client)) as string[]).length, 4 * CELLS);
    await search.fill("nothing of this name");
    await list(client).getByText("No patch has all of these words").waitFor();
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a click in the picture names the patch, hides it, and shows it alone; each is one step of undo", async () => {
    const client = await open();
    const whole = await client.picture();
    const box = await client.canvas.boundingBox();
    const middle = { x: (box?.width ?? 0) / 2, y: (box?.height ?? 0) / 2 };
    await client.canvas.click({ position: middle });
    const card = client.page.getByLabel("Values at the clicked point");
    await card.getByText("bar_8-front").waitFor();
    await client.keep("patch-named");
    await card.getByRole("button", { name: "Hide" }).click();
    await client.settled();
    const names = (await groups(client)) as string[];
    assert.deepEqual([names.length, names.includes("bar_8-front")], [1 + 4 * CELLS, false]);
    assert.ok(difference(whole, await client.picture()) > 0.0005, "a hole, through which the back side is seen");
    assert.equal(await card.count(), 0);
    await client.button("Undo").click();
    assert.deepEqual(await groups(client), []);
    await client.canvas.click({ position: middle });
    await card.getByRole("button", { name: "Only this" }).click();
    assert.deepEqual(await groups(client), ["bar_8-front"]);
    await client.button("Undo").click();
    assert.deepEqual(await groups(client), []);
    await client.settled();
    assert.ok(difference(whole, await client.picture()) < 0.001);
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
