// Tests that after the choice of another dataset, the page shows nothing of the previous dataset as if it were of the
// new one.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { cubeIn } from "./cube.ts";
import { heldOpening } from "./held_opening.ts";
import type { Client, PageOptions } from "./page.ts";
import { nameOf, Server } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

describe("choosing another dataset", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-choosing-"));
  const first = nameOf(data[0] ?? "");
  let server: Server;
  before(async () => {
    server = await Server.started([data[0] ?? "", cubeIn(folder)]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  /** Opens a page that shows the larger of the two datasets. */
  async function onFirst(options: PageOptions = {}): Promise<Client> {
    const client = await stage.open(server.address, options);
    await client.settled();
    await client.choose(first);
    await client.settled();
    return client;
  }

  const heldNow = (client: Client, what: string): Promise<unknown> =>
    client.page.waitForFunction((wanted) => (globalThis as unknown as { held: unknown }).held === wanted, what);
  const pass = (client: Client): Promise<void> => client.page.evaluate("globalThis.pass()");
  const letGo = (client: Client): Promise<void> => client.page.evaluate("globalThis.letGo()");
  const numbers = (client: Client): Promise<string[]> =>
    client.page
      .locator(":is(.texts text, .histogram-ends, .status-bar span, .time-bar output):visible")
      .allTextContents();
  const visibleNumbers = async (client: Client): Promise<string> => (await numbers(client)).join(" ").trim();

  test("no number stands beside the other dataset's name, and the picture is dim, until the first picture", async () => {
    const client = await onFirst({ before: heldOpening, width: 1280, height: 800 });
    const summary = client.page.locator(".dataset-summary");
    assert.match((await summary.textContent()) ?? "", new RegExp(`^${first}.* cells .* time steps .* arrays`));
    assert.equal(await summary.locator(".hint").textContent(), "from ciel demo");
    const top = await summary.evaluate((element) => element.getBoundingClientRect().bottom);
    assert.ok(top < 200, `what the dataset is ends at ${top} pixels`);
    assert.match(await visibleNumbers(client), /triangles/);

    await client.page.evaluate("globalThis.holding = true");
    await client.page.getByLabel("Dataset", { exact: true }).selectOption("cube");
    await heldNow(client, "description");
    const opening = client.page.locator(".busy");
    assert.equal(await opening.textContent(), "Opening cube");
    const filter = await client.canvas.evaluate((element) => getComputedStyle(element).filter);
    assert.match(filter, /grayscale\(1\).*opacity\(0\.25\)/, "the picture of the other dataset is gray and faint");
    assert.equal(await visibleNumbers(client), "");
    assert.equal(await client.page.locator(".side-panel .section:visible").count(), 0);
    await client.keep("opening-description");

    await pass(client);
    await heldNow(client, "picture");
    assert.equal(await opening.textContent(), "Opening cube");
    assert.equal(await client.page.locator(".stage.opening").count(), 1);
    assert.equal(await client.page.locator(".legend, .texts text, .status-bar span:visible").count(), 0);
    assert.match((await summary.textContent()) ?? "", /^cube1 cell · 1 time step/);
    await client.keep("opening-picture");

    await letGo(client);
    await client.settled();
    assert.equal(await client.page.locator(".stage.opening").count(), 0);
    assert.equal(await opening.count(), 0);
    await client.keep("opened");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("an undo to the dataset before opens it in the same way", async () => {
    const client = await onFirst({ before: heldOpening });
    await client.choose("cube");
    await client.settled();
    await client.page.evaluate("globalThis.holding = true");
    await client.button("Undo").click();
    await client.page.getByText(`Opening ${first}`).first().waitFor();
    assert.equal(await client.page.locator(".legend, .texts text, .status-bar span:visible").count(), 0);
    await letGo(client);
    await client.settled();
    assert.equal(await client.page.locator(".stage.opening").count(), 0);
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a dataset that cannot be opened leaves what was there", async () => {
    const client = await onFirst();
    // Ignores times and frames per second ("idle" without frames), which change all the time.
    const kept = async (): Promise<string> => (await visibleNumbers(client)).replace(/[\d.]+ (ms|fps)|idle/g, "");
    // Waits until the layout of the legends no longer changes.
    let before = await kept();
    for (let last = ""; last !== before; before = await kept()) {
      last = before;
      await client.page.waitForTimeout(300);
    }
    await client.page.evaluate(() => {
      const select = document.querySelector<HTMLSelectElement>(".dataset-select select");
      const option = document.createElement("option");
      option.value = "nowhere";
      select?.append(option);
    });
    await client.page.getByLabel("Dataset", { exact: true }).selectOption("nowhere");
    await client.toast("nowhere").waitFor();
    assert.equal(await client.page.locator(".stage.opening").count(), 0);
    assert.equal(await client.page.getByLabel("Dataset", { exact: true }).inputValue(), first);
    assert.equal(await kept(), before);
    await client.close();
  });
});
