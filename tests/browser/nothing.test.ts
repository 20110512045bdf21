// Tests that the page explains why it has no picture, and what the user can do.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, renameSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, describe, test } from "node:test";
import { cubeIn } from "./cube.ts";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { Server } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

describe("nothing", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-nothing-"));
  const away = mkdtempSync(join(tmpdir(), "ciel-away-"));
  let server: Server;
  let moved = NaN; // iso-value of the scene when the server lost its dataset
  before(async () => {
    for (const name of ["here", "gone"]) execFileSync("cp", ["-al", data[0] ?? "", join(folder, `${name}.ciel`)]);
    server = await Server.started([folder]);
  });
  after(async () => {
    await server.stop();
    for (const path of [folder, away]) rmSync(path, { recursive: true });
  });
  const [here, elsewhere] = [join(folder, "gone.ciel"), join(away, "gone.ciel")];
  const remove = (): void => renameSync(here, elsewhere);
  const giveBack = (): void => {
    if (existsSync(elsewhere)) renameSync(elsewhere, here);
  };
  afterEach(giveBack);
  const shown = (client: Client): Promise<number> => client.page.locator(".canvases canvas:visible").count();

  async function listed(): Promise<void> {
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "dataset.list", params: {} });
    const headers = { "Content-Type": "application/json" };
    await fetch(new URL("rpc", server.address), { method: "POST", headers, body });
  }

  /** Opens a page whose server then restarts without the page's dataset. */
  async function lost(scheme: "dark" | "light"): Promise<Client> {
    const iso = { type: "iso", array: "tracer", values: [0.4] };
    const client = await stage.open(server.address + fragmentOf({ dataset: "gone", layers: { iso } }), { scheme });
    await client.settled();
    await client.dragIso(0.6);
    await client.settled();
    moved = await client.value();
    await server.stop("SIGKILL");
    remove();
    await server.start();
    await client.page.getByText("There is no dataset 'gone'").waitFor({ timeout: 30_000 });
    assert.equal(await shown(client), 0, "no picture of what is not here");
    assert.equal(await client.page.locator(".legend, .triad, .toast, .section").count(), 0);
    for (const name of ["Undo", "Save a picture", "Export a surface"])
      assert.ok(await client.button(name).isDisabled(), name);
    await client.keep(`dataset-gone-${scheme}`);
    return client;
  }

  test("a dataset that is gone when the server is back: another is opened at once", async () => {
    const client = await lost("dark");
    await client.button("here").click();
    await client.page.waitForFunction(() => document.title.startsWith("here "));
    await client.settled();
    assert.equal(await shown(client), 1);
    assert.ok(await client.button("Undo").isDisabled());
    const before = await client.picture();
    await client.dragCanvas([0.5, 0.5], [0.7, 0.5]);
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.005, "the page is alive");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("from the toolbar too, and by a link", async () => {
    const client = await lost("light");
    await client.choose("here");
    await client.settled();
    await client.close();
    giveBack();
    const other = await lost("light");
    await other.page.evaluate((hash) => void (location.hash = hash), fragmentOf({ dataset: "here" }));
    await other.settled();
    assert.match(await other.page.title(), /^here /);
    await other.close();
  });

  test("a dataset that is there again shows the scene that was kept", async () => {
    const client = await lost("dark");
    await client.button("Try again").click();
    await client.button("Try again").waitFor(); // another name until the server has refused
    assert.equal(await client.page.getByText("There is no dataset 'gone'").count(), 1);
    giveBack();
    await client.button("Try again").click();
    await client.settled();
    assert.equal(await client.value(), moved);
    assert.match(await client.page.title(), /^gone /);
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("an undo to a dataset that was removed is said, and later steps are undone all the same", async () => {
    const client = await stage.open(server.address);
    await client.settled();
    await client.choose("gone");
    await client.settled();
    await client.choose("here");
    await client.settled();
    remove();
    await listed(); // makes the server notice the missing dataset
    await client.button("Undo").click();
    await client.toast("The change cannot be undone. There is no dataset 'gone'").waitFor();
    await client.keep("undo-to-nowhere");
    assert.ok(await client.button("Undo").isDisabled());
    await client.settled();
    await client.button("Add an iso-surface").click();
    await client.settled();
    const value = await client.value();
    await client.dragIso(0.3);
    await client.settled();
    assert.notEqual(await client.value(), value);
    await client.button("Undo").click();
    await client.reached(value);
    await client.settled();
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a slice beside the data, values without a surface, an array of one value", async () => {
    const cube = await Server.started([cubeIn(away)]);
    const layers = { slice: { type: "slice", axis: "z", value: 0.5, color: { array: "c" } } };
    const client = await stage.open(cube.address + fragmentOf({ dataset: "cube", layers }));
    await client.settled();
    const legend = client.page.getByLabel("Colors of c");
    await legend.waitFor();
    assert.deepEqual(await client.page.locator(".texts text").allTextContents(), ["c", "the same everywhere", "3"]);
    assert.equal(await legend.getByRole("textbox").count(), 0, "there is no range to change");
    await client.keep("one-value");
    const field = client.page.getByLabel("Position on z");
    await field.fill("7");
    await field.press("Enter");
    await client.page.getByText("No slice: z goes from 0 to 1.").waitFor();
    await client.page.getByText("No visible layer meets the data at this time").waitFor();
    await client.keep("empty");
    await field.fill("0.25");
    await field.press("Enter");
    await client.settled();
    assert.equal(await client.page.locator(".lacking").count(), 0);
    await client.close();
    await cube.stop();
  });

  test("edges and points alone are something that is seen; a surface beside the data is not", async () => {
    const cube = await Server.started([cubeIn(mkdtempSync(join(folder, "cube-")))]);
    const outside = { type: "iso", array: "x", values: [7] };
    for (const [layers, sentences] of [
      [{ edges: { type: "edges" } }, 0],
      [{ points: { type: "points" } }, 0],
      [{ outside, points: { type: "points" } }, 0],
      [{ outside }, 2],
    ] as const) {
      const client = await stage.open(cube.address + fragmentOf({ dataset: "cube", layers }));
      await client.settled();
      assert.equal(await client.page.locator(".lacking p").count(), sentences, JSON.stringify(layers));
      assert.deepEqual(client.problems, []);
      await client.close();
    }
    await cube.stop();
  });

  test("layers that show nothing have no legend, and each says why in its row; the view stays", async () => {
    const cube = await Server.started([cubeIn(mkdtempSync(join(folder, "cube-")))]);
    const color = { array: "x" };
    const surface = { type: "surface", color, threshold: { array: "x", range: [5, 6], enabled: false } };
    const client = await stage.open(cube.address + fragmentOf({ dataset: "cube", layers: { surface } }));
    await client.settled();
    const legend = client.page.getByLabel("Colors of x");
    const notice = client.page.locator(".lacking");
    await client.page.getByRole("button", { name: "Layers", exact: true }).click();
    const row = client.page.locator("[data-layer=surface]");
    assert.equal(await legend.count(), 1);
    assert.equal(await client.page.locator(".layer-empty").count(), 0);
    const session = (await client.page.evaluate(() => sessionStorage.getItem("ciel.session"))) ?? "";
    const call = async (method: string, params: object): Promise<unknown> => {
      const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method, params });
      const headers = { "Content-Type": "application/json" };
      const answer = await fetch(new URL("rpc", cube.address), { method: "POST", headers, body });
      return ((await answer.json()) as { result: unknown }).result;
    };
    const change = async (patch: object): Promise<void> => {
      await call("scene.patch", { session, patch });
      await client.page.waitForTimeout(200);
      await client.settled();
    };
    const camera = async (): Promise<string> =>
      JSON.stringify(((await call("scene.get", { session })) as { scene: { camera: unknown } }).scene.camera);
    const before = await camera();
    const off = { opacity: 1, threshold: { enabled: false } };
    for (const [patch, reason] of [
      [{ layers: { surface: { ...off, opacity: 0 } } }, "The opacity is 0."],
      [{ layers: { surface: { threshold: { enabled: true } } } }, "The threshold from 5 to 6 keeps no cell"],
      [{ layers: { c: { type: "clip", axis: "x", value: -1 } } }, "The clip planes cut away the whole layer."],
    ] as const) {
      await change({ layers: { surface: off, c: null } });
      assert.equal(await legend.count(), 1, reason);
      assert.equal(await notice.count(), 0);
      await change(patch);
      assert.match((await row.textContent()) ?? "", new RegExp(`The layer shows nothing. ${reason}`));
      assert.match((await notice.textContent()) ?? "", new RegExp(reason), "an empty picture is explained");
      assert.equal(await legend.count(), 0, reason);
      await client.keep(`empty-${reason.split(" ")[1] ?? ""}`);
    }
    assert.equal(await camera(), before);
    assert.deepEqual(client.problems, []);
    await client.close();
    await cube.stop();
  });

  test("R frames what a clip leaves, with Shift the whole box; the view stays while the plane is moved", async () => {
    const cube = await Server.started([cubeIn(mkdtempSync(join(folder, "cube-")))]);
    const layers = { surface: { type: "surface" }, clip: { type: "clip", axis: "x", value: 0.9 } };
    const lighting = { on: false };
    const client = await stage.open(cube.address + fragmentOf({ dataset: "cube", layers, lighting }));
    await client.settled();
    const height = async (): Promise<number> => {
      const picture = await client.picture();
      const rows = Array.from({ length: picture.height }, (_, y) => y).filter((y) =>
        Array.from({ length: picture.width }, (_, x) => x).some((x) => Math.max(...picture.at(x, y)) > 100),
      );
      return rows.length;
    };
    const session = (await client.page.evaluate(() => sessionStorage.getItem("ciel.session"))) ?? "";
    const patch = async (change: object): Promise<void> => {
      const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "scene.patch", params: { session, patch: change } });
      await fetch(new URL("rpc", cube.address), {
        method: "POST",
        headers: { "Content-Type": "application/json" },
        body,
      });
      await client.page.waitForTimeout(200);
      await client.settled();
    };
    const press = async (key: string): Promise<number> => {
      await client.page.keyboard.press(key);
      await client.page.waitForTimeout(300); // time for the page to ask for the bounds
      await client.settled();
      return height();
    };
    const corner = (at: number): object => ({
      layers: {
        clip: { value: at },
        y: { type: "clip", axis: "y", value: at },
        z: { type: "clip", axis: "z", value: at },
      },
    });
    const whole = await press("r");
    await patch(corner(0.25));
    const small = await height();
    assert.ok(small < 0.5 * whole, `${small} of ${whole} rows: the view has not moved`);
    const framed = await press("r");
    assert.ok(Math.abs(framed / whole - 1) < 0.15, `${framed} rows, as the whole had ${whole}`);
    await client.keep("framed-corner");
    assert.ok(Math.abs((await press("Shift+R")) - small) < 0.15 * small);
    await client.button("Undo").click();
    await client.settled();
    assert.ok(Math.abs((await height()) - framed) < 3, "one step of undo");
    assert.deepEqual(client.problems, []);
    await client.close();
    await cube.stop();
  });
});
