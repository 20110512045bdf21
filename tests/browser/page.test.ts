// Tests links, time steps, themes, window sizes, a lost server, and messages.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { sceneOf } from "./link.ts";
import type { Client } from "./page.ts";
import { decodePng, difference, distance, type Picture } from "./png.ts";
import { nameOf, Server } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const modules = resolve(dirname(fileURLToPath(import.meta.url)), "../../webclient/node_modules");

describe("page", { skip }, () => {
  const stage = new Stage();

  test("the first picture is the body and a slice through it, at the last step, from nearby", async () => {
    const client = await stage.open(stage.server.address);
    await client.settled();
    await client.addressed();
    const { time, camera, layers } = sceneOf(client.page.url()) as {
      time: number;
      camera: { position: number[]; target: number[] };
      layers: Record<string, { type: string; groups?: string[]; color?: { array?: string } }>;
    };
    assert.deepEqual(
      Object.values(layers)
        .map(({ type }) => type)
        .sort(),
      ["outline", "slice", "surface"],
    );
    assert.deepEqual(layers.surface?.groups, ["cylinder"]);
    assert.equal(layers.slice?.color?.array, "U:magnitude");
    assert.equal(time, 0.95);
    const away = Math.hypot(...camera.position.map((at, i) => at - (camera.target[i] ?? 0)));
    assert.ok(away < 20, `the domain is 21 long, and the camera ${away} away from the cylinder`);
    await client.keep("first-picture");
    await client.close();
  });

  test("a link opens the same view in another browser", async () => {
    const client = await stage.fresh();
    await client.dragIso(0.7);
    await client.dragCanvas([0.4, 0.5], [0.6, 0.3]);
    await client.settled();
    const picture = await client.picture();
    await client.addressed();
    const link = client.page.url();
    assert.match(link, /#s=[A-Za-z0-9_-]{40,}$/);
    const other = await stage.open(link);
    await other.settled();
    assert.ok(difference(picture, await other.picture()) < 0.005);
    assert.equal(await other.value(), await client.value());
    await client.close();
    await other.close();
  });

  test("a damaged link is said, and the page works all the same", async () => {
    const client = await stage.open(`${stage.server.address}#s=abc`);
    await client.page.getByText("does not hold a whole scene").waitFor();
    await client.settled();
    await client.close();
  });

  /** Opens a page, drags the iso-value as one step, and reloads the page. Returns the value before the drag, too. */
  async function draggedAndReloaded(): Promise<{ client: Client; before: number }> {
    const client = await stage.fresh({ scheme: "light" }); // a reload sometimes resets Chromium to this scheme
    const before = await client.value();
    await client.dragIso(0.3);
    await client.settled();
    const value = await client.value();
    assert.equal(new Set(client.patches.map(({ gesture }) => gesture)).size, 1);
    await client.addressed();
    await reloaded(client, value);
    return { client, before };
  }

  async function reloaded(client: Client, value: number): Promise<void> {
    await client.page.reload();
    await client.settled();
    assert.equal(await client.value(), value);
  }

  async function undone(client: Client, value: number): Promise<void> {
    await client.button("Undo").click();
    await client.settled();
    assert.equal(await client.value(), value);
  }

  test("reloading keeps the session and its undo", async () => {
    const { client, before } = await draggedAndReloaded();
    await undone(client, before);
    await client.close();
  });

  test("a theme that changes after a reload is no undo step of its own", async () => {
    const { client, before } = await draggedAndReloaded();
    client.patches.length = 0;
    await client.page.emulateMedia({ colorScheme: "dark" });
    await client.patched();
    await client.settled();
    await undone(client, before);
    await client.close();
  });

  test("undo survives two reloads and a restart of the server between them", async () => {
    const { client, before } = await draggedAndReloaded();
    const value = await client.value();
    await stage.server.stop("SIGKILL");
    await stage.server.start();
    await reloaded(client, value);
    await undone(client, before);
    await client.close();
  });

  test("the server dies and comes back: the scene is kept, and what the hand did meanwhile", async () => {
    const client = await stage.same();
    await client.dragIso(0.65);
    await client.settled();
    const picture = await client.picture();
    const value = await client.value();
    await stage.server.stop("SIGKILL");
    await client.page.getByText("The server does not answer").waitFor();
    await client.keep("server-gone");
    await client.isoValue.focus();
    await client.page.keyboard.press("PageUp");
    const moved = await client.value();
    assert.notEqual(moved, value);
    await stage.server.start();
    await client.connected();
    await client.settled();
    assert.equal(await client.value(), moved);
    // The page has handed its steps to the new server.
    await client.button("Undo").click();
    await client.reached(value);
    await client.button("Redo").click();
    await client.reached(moved);
    await client.settled();
    await client.isoValue.focus();
    await client.page.getByLabel("Iso-value", { exact: true }).fill(String(value));
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(difference(picture, await client.picture()) < 0.005);
    assert.deepEqual(client.problems, []);
  });

  test("it comes back by itself", async () => {
    const client = await stage.same();
    const before = await client.picture();
    await stage.server.stop();
    await client.page.getByText("The server does not answer").waitFor();
    await stage.server.start();
    await client.connected();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005, "with the picture that was there");
  });

  test("offline is said at once", async () => {
    const client = await stage.same();
    await client.page.context().setOffline(true);
    await client.page.getByText("This computer is offline").waitFor();
    await client.page.context().setOffline(false);
    await client.connected();
    await client.settled();
  });

  test("time plays, pauses and steps", async (context) => {
    const client = await stage.same();
    const slider = client.page.getByLabel("Time step", { exact: true });
    for (const path of data) {
      if ((await slider.count()) > 0) break;
      await client.choose(nameOf(path));
      await client.settled();
    }
    if ((await slider.count()) === 0) {
      context.skip("no dataset has more than one time step");
    } else {
      const first = await client.picture();
      const step = await slider.inputValue();
      client.patches.length = 0;
      await client.button("Play").click();
      await client.patched(3);
      await client.button("Pause").click();
      await client.settled();
      assert.equal(new Set(client.patches.map(({ gesture }) => gesture)).size, 1);
      await client.button("Undo").click();
      await client.settled();
      assert.equal(await slider.inputValue(), step);
      await client.button("Step on").click();
      await client.settled();
      assert.equal(Number(await slider.inputValue()), Number(step) + 1);
      assert.ok(difference(first, await client.picture()) > 0.001);
    }
  });

  test("light and dark", async () => {
    // The link has no scene: a scene's background would replace the theme's.
    const light = await stage.open(stage.server.address, { scheme: "light" });
    await light.settled();
    await light.keep("light");
    const bright = (await light.picture()).at(3, 3);
    assert.ok(distance(bright, [255, 255, 255]) < 12, `light: ${bright.join()}`);
    await light.button(/^Theme/).click();
    await light.button(/^Theme/).click();
    await light.settled();
    const dark = (await light.picture()).at(3, 3);
    assert.ok(distance(dark, [26, 31, 41]) < 12, `dark: ${dark.join()}`);
    await light.close();
  });

  test("another size, and more pixels for a sharper screen", async () => {
    const client = await stage.fresh({ scale: 2, width: 1000, height: 640 });
    const size = (): Promise<number[]> =>
      client.page
        .locator("canvas")
        .first()
        .evaluate((canvas: HTMLCanvasElement) => [canvas.width, canvas.clientWidth]);
    const [pixels = 0, css = 1] = await size();
    assert.equal(pixels, 2 * css);
    await client.page.setViewportSize({ width: 1280, height: 720 });
    await client.page.waitForFunction(
      (old) => document.querySelector<HTMLCanvasElement>("canvas:not([hidden])")?.width !== old,
      pixels,
    );
    await client.settled();
    const [more = 0, wider = 1] = await size();
    assert.ok(wider > css);
    assert.equal(more, 2 * wider);
    await client.close();
  });

  test("the saved picture is a lossless still of the view's size", async () => {
    const client = await stage.same();
    const [file] = await Promise.all([client.page.waitForEvent("download"), client.button("Save a picture").click()]);
    const saved = decodePng(await readFile(await file.path()));
    const seen = await client.picture();
    assert.deepEqual([saved.width, saved.height], [seen.width, seen.height]);
    // Compares without legend and triad. The page draws them as overlays, which picture() hides; saved pictures contain
    // them.
    const between = (picture: Picture): Picture => {
      const left = Math.round(0.2 * picture.width);
      return { width: Math.round(0.55 * picture.width), height: picture.height, at: (x, y) => picture.at(left + x, y) };
    };
    assert.ok(difference(between(saved), between(seen)) < 0.002);
    assert.ok(difference(saved, seen) > 0.002, "the legend and the triad are in what is saved");
  });

  test("a surface leaves as a file", async () => {
    const client = await stage.same();
    await client.button("Export a surface").click();
    const surface = client.page.getByLabel("Surface", { exact: true });
    const names = await surface.locator("option").allTextContents();
    assert.ok(
      names.some((name) => /^Iso-surface of \S+ at [\d.]/.test(name)),
      names.join(),
    );
    await client.keep("export");
    await surface.selectOption("iso");
    const [file] = await Promise.all([client.page.waitForEvent("download"), client.button("PLY").click()]);
    const text = (await readFile(await file.path())).toString("latin1");
    assert.match(text, /^ply\n/);
    assert.match(text, /element face [1-9]/);
  });

  test("help opens by key and closes by Escape", async () => {
    const client = await stage.same();
    await client.page.keyboard.press("?");
    await client.page.getByRole("dialog").waitFor();
    await client.keep("help");
    await client.page.keyboard.press("Escape");
    await client.page.getByRole("dialog").waitFor({ state: "detached" });
  });

  test("every control has a name", async () => {
    const client = await stage.same();
    for (const role of ["button", "checkbox", "combobox", "slider", "textbox"] as const) {
      assert.notEqual(await client.page.getByRole(role).count(), 0, role);
      const nameless = client.page.getByRole(role, { name: /^\s*$/ });
      assert.deepEqual(await nameless.evaluateAll((all) => all.map((e) => e.outerHTML)), []);
    }
  });

  test("axe finds nothing, with help and menus open or not", async () => {
    const client = await stage.same();
    const source = readFileSync(join(modules, "axe-core/axe.min.js"), "utf8");
    await client.page.evaluate(source);
    const findings = (): Promise<string[]> =>
      client.page.evaluate(async () => {
        interface Finding {
          id: string;
          nodes: { html: string }[];
        }
        const { axe } = globalThis as unknown as { axe: { run: () => Promise<{ violations: Finding[] }> } };
        const { violations } = await axe.run();
        return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
      });
    assert.deepEqual(await findings(), []);
    await client.page.keyboard.press("?");
    assert.deepEqual(await findings(), []);
    await client.page.keyboard.press("Escape");
    await client.button("Pictures of other sizes").click();
    assert.deepEqual(await findings(), []);
    await client.button("Pictures of other sizes").click();
  });

  test("below a path prefix", async () => {
    const below = await Server.started(data, { prefix: "/some/where" });
    const client = await stage.open(below.address);
    await client.settled();
    await client.close();
    await below.stop();
  });

  test("a server without datasets says so", async () => {
    const empty = await Server.started([]);
    const client = await stage.open(empty.address);
    await client.page.getByText("The server has no dataset").waitFor();
    await client.close();
    await empty.stop();
  });
});
