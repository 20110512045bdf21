// Tests the page with others: a server that asks for a token, other clients, appended time steps, links from elsewhere.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, test } from "node:test";
import { appendStep } from "./append.ts";
import { fragmentOf } from "./link.ts";
import { difference, distance } from "./png.ts";
import { nameOf, Server } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const dataset = nameOf(data[0] ?? "");

describe("company", { skip }, () => {
  const stage = new Stage();

  test("a server that asks for a token says so, and takes it", async () => {
    const token = "open-sesame-1";
    const guarded = await Server.started(data, { token });
    const client = await stage.open(guarded.address);
    await client.page.getByText("This server asks for its token").waitFor();
    await client.keep("token");
    const field = client.page.getByRole("textbox", { name: "Token" });
    await field.fill("wrong-token");
    await client.page.keyboard.press("Enter");
    await client.page.getByText("The token is wrong.").waitFor();
    await field.fill(`${guarded.address}?token=${token}`);
    await client.button("Enter").click();
    await client.settled();
    assert.ok(!client.page.url().includes("token"), client.page.url());
    await client.page.reload();
    await client.settled(); // the cookie replaces the token
    await client.close();
    const invited = await stage.open(`${guarded.address}?token=${token}`);
    await invited.settled();
    assert.ok(!invited.page.url().includes("token"), invited.page.url());
    await invited.close();
    await guarded.stop();
  });

  test("two clients of one session see the same, and either takes a step back; a third has its own", async () => {
    const [one, stranger] = [await stage.fresh(), await stage.fresh()];
    const session = await one.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const two = await stage.fresh({ before: `sessionStorage.setItem("ciel.session", "${session ?? ""}")` });
    assert.equal(await two.value(), await one.value());
    const before = await two.picture();
    const value = await one.value();
    await one.dragIso(0.7);
    await one.settled();
    await two.reached(await one.value());
    await two.settled();
    assert.ok(difference(before, await two.picture()) > 0.01);
    assert.ok(difference(await one.picture(), await two.picture()) < 0.005);
    await two.button("Undo").click();
    await two.settled();
    await one.reached(value);
    await one.button("Redo").click();
    await one.settled();
    assert.notEqual(await one.value(), value);
    assert.equal(await stranger.value(), value);
    assert.ok(await stranger.button("Undo").isDisabled());
    for (const client of [one, two, stranger]) {
      assert.deepEqual(client.problems, []);
      await client.close();
    }
  });

  test("what is typed for a slice that another window removes is not sent, and the page says why", async () => {
    const layers = { a: { type: "slice", axis: "x", value: 2 }, b: { type: "slice", axis: "x", value: 8 } };
    const one = await stage.fresh({}, fragmentOf({ dataset, layers }));
    const session = await one.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const two = await stage.fresh({ before: `sessionStorage.setItem("ciel.session", "${session ?? ""}")` });
    const card = two.page.getByRole("article", { name: "Slice at x = 8" });
    await card.getByRole("textbox", { name: "Position on x" }).fill("7");
    await one.button("Remove this slice").last().click();
    await card.waitFor({ state: "detached" });
    await two.page.keyboard.press("Enter");
    await two.toast("Slice at x = 8 no longer exists: another window or a script has removed the layer").waitFor();
    await two.settled();
    assert.equal(await two.page.locator(".toast").count(), 1);
    assert.deepEqual(two.patches, []);
    for (const client of [one, two]) await client.close();
  });

  test("a step that a simulation appends arrives while the page is open", async () => {
    const folder = mkdtempSync(join(tmpdir(), "ciel-browser-"));
    const growing = join(folder, "growing.ciel");
    execFileSync("cp", ["-al", data[0] ?? "", growing]); // hard links: appending replaces files
    const live = await Server.started([growing]);
    const client = await stage.open(live.address);
    await client.settled();
    const slider = client.page.getByLabel("Time step", { exact: true });
    const last = (await slider.count()) > 0 ? Number(await slider.getAttribute("max")) : 0;
    await appendStep(live.address, growing, folder);
    await client.toast("1 more time step has arrived").waitFor();
    await client.keep("appended");
    const before = await client.picture();
    await slider.focus();
    await client.page.keyboard.press("End");
    await client.settled();
    assert.equal(Number(await slider.getAttribute("max")), last + 1);
    assert.equal(Number(await slider.inputValue()), last + 1);
    assert.ok(difference(before, await client.picture()) > 0.005);
    assert.deepEqual(client.problems, []);
    await client.close();
    await live.stop();
    rmSync(folder, { recursive: true });
  });

  test("the system turns from dark to light, and the picture with it", async () => {
    const client = await stage.fresh({ scheme: "dark" });
    const surface = (): Promise<string> =>
      client.page.locator(".toolbar").evaluate((element) => getComputedStyle(element).backgroundColor);
    const dark = await surface();
    assert.ok(distance((await client.picture()).at(3, 3), [26, 31, 41]) < 12);
    const value = await client.value();
    await client.dragIso(0.3);
    await client.settled();
    await client.taken(() => client.page.emulateMedia({ colorScheme: "light" }));
    await client.settled();
    assert.notEqual(await surface(), dark);
    assert.ok(distance((await client.picture()).at(3, 3), [255, 255, 255]) < 12);
    await client.taken(() => client.page.emulateMedia({ colorScheme: "dark" }));
    await client.settled();
    assert.equal(await surface(), dark);
    assert.ok(distance((await client.picture()).at(3, 3), [26, 31, 41]) < 12);
    await client.button("Undo").click(); // the change of the color scheme is not an undo step
    await client.settled();
    assert.equal(await client.value(), value);
    await client.close();
  });

  test("the session's link opens the same session elsewhere, and what one changes the other sees", async () => {
    const client = await stage.fresh();
    await client.page.evaluate(() => void Object.defineProperty(navigator, "clipboard", { value: undefined }));
    await client.button("Share").click();
    await client.button("Copy a link to this session").click();
    await client.page.getByText("The link to this session is in the address bar").waitFor();
    const link = client.page.url();
    assert.match(link, /#j=[A-Za-z0-9_-]{22,64}$/);
    const guest = await stage.open(link);
    await guest.settled();
    assert.ok(!guest.page.url().includes("#j="), "the key does not stay in the address");
    await client.dragIso(0.75);
    await client.settled();
    await guest.reached(await client.value());
    await guest.close();
    await client.close();
  });

  test("a link that is followed on the open page is shown, one step back from what was there", async () => {
    const client = await stage.fresh();
    const before = await client.picture();
    const value = await client.value();
    await client.dragIso(0.75);
    await client.settled();
    const [moved, wanted] = [await client.picture(), await client.value()];
    await client.addressed();
    const link = new URL(client.page.url()).hash;
    await client.button("Undo").click();
    await client.settled();
    await client.addressed(); // the address must first follow the undo
    await client.page.evaluate((hash) => void (location.hash = hash), link);
    await client.reached(wanted);
    await client.settled();
    assert.ok(difference(moved, await client.picture()) < 0.005);
    await client.button("Undo").click();
    await client.settled();
    assert.equal(await client.value(), value);
    assert.ok(difference(before, await client.picture()) < 0.005);
    await client.close();
  });

  test("links that no server can show are said; the open page stays as it was", async () => {
    const client = await stage.fresh();
    const before = await client.picture();
    const rubbish: unknown[] = [
      { dataset: "nowhere" },
      { dataset, layers: { iso: { type: "iso" } } },
      { dataset, layers: 5, camera: "left" },
      { dataset, layers: { iso: { type: "iso", array: "no such array", values: [1] } } },
      { dataset, time: "now", camera: { position: [0, 0], target: [] } },
    ];
    for (const scene of rubbish) {
      await client.page.evaluate((hash) => void (location.hash = hash), fragmentOf(scene));
      await client.page.locator(".toast.error").first().waitFor();
      await client.button("Close the message").first().click();
    }
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
    await client.dragIso(0.6);
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.005, "the page is alive");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a link to a dataset that is not here opens a page from which one is chosen", async () => {
    const client = await stage.open(stage.server.address + fragmentOf({ dataset: "nowhere", layers: {} }));
    await client.page.getByText("Nothing can be shown").waitFor();
    await client.keep("link-to-nowhere");
    await client.choose(dataset);
    await client.settled();
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a scene that can hardly be seen is a scene all the same", async () => {
    const camera = { position: [1e6, 1e6, 1e6], target: [0, 0, 0], up: [0, 0, 1] };
    const client = await stage.fresh({}, fragmentOf({ dataset, camera }));
    await client.button("Show what is drawn").click();
    await client.settled();
    await client.button("Add an iso-surface").click();
    await client.settled();
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
