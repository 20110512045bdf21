// Tests the defaults: looks of new layers, legends, ranges, exports, picture sizes, copied values.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Locator } from "./chromium.ts";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

interface Layer {
  type: string;
  invert?: boolean;
  opacity_points?: [number, number][];
  color?: { array?: string; solid?: string; range?: [number, number] };
}

/** Camera at the positive x end of the dataset. */
const camera = { position: [40, -20, 12], target: [5, 0, 2], up: [0, 0, 1] };
const slice = { type: "slice", axis: "z", value: 2, color: { array: "vorticity" } };
const iso = { type: "iso", array: "tracer", values: [0.4], color: { array: "U:magnitude" } };

describe("defaults", { skip }, () => {
  const stage = new Stage();
  let client: Client;
  before(async () => {
    const scene = { dataset: nameOf(data[0] ?? ""), camera, layers: { iso, slice } };
    client = await stage.fresh({ width: 1280, height: 800 }, fragmentOf(scene));
  });

  const rpc = async (method: string, params: object): Promise<unknown> => {
    const session = await client.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method, params: { session, ...params } });
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch(new URL("rpc", stage.server.address), { method: "POST", headers, body });
    return ((await answer.json()) as { result: unknown }).result;
  };
  const layers = async (): Promise<Record<string, Layer>> => {
    await client.settled();
    return ((await rpc("scene.get", {})) as { scene: { layers: Record<string, Layer> } }).scene.layers;
  };
  const added = async (button: string): Promise<Layer> => {
    const known = Object.keys(await layers());
    await client.button(button).click();
    const now = await layers();
    const [id = ""] = Object.keys(now).filter((other) => !known.includes(other));
    return now[id] ?? { type: "none" };
  };
  const undo = async (): Promise<void> => {
    await client.button("Undo").click();
    await client.settled();
  };

  /** Unfolds the looks of the slice's card and returns the card. */
  const sliceCard = async (): Promise<Locator> => {
    const card = client.page.getByRole("article", { name: /^Slice at/ });
    const looks = card.getByRole("button", { name: /^Looks/ });
    if ((await looks.getAttribute("aria-expanded")) === "false") await looks.click();
    return card;
  };

  test("a clip keeps the half whose cut faces the eye", async () => {
    assert.notEqual((await added("Add a clip across x")).invert, true);
    await undo();
    assert.equal((await added("Add a clip across y")).invert, true);
    await undo();
  });

  test("a further iso-surface, slice and layer of the boundary do not look like those that are there", async () => {
    assert.equal((await added("Add a slice across x")).color?.array, "tracer");
    await undo();
    const first = await added("Add an iso-surface");
    const second = await added("Add an iso-surface");
    assert.notEqual(first.color?.solid, second.color?.solid);
    await undo();
    await undo();
    await rpc("scene.patch", { patch: { layers: { wall: { type: "surface" } } } });
    const { wall } = await layers();
    const another = await added("Add another layer of the boundary");
    assert.notEqual(another.color?.solid, wall?.color?.solid);
    await undo();
    await undo();
  });

  test("a volume's first opacity is low where most of the values are", async () => {
    const before = await client.picture();
    const { opacity_points: points = [] } = await added("Add a volume");
    const lowest = Math.min(...points.map(([, opacity]) => opacity));
    assert.ok(points.length >= 3 && lowest < 0.02, JSON.stringify(points));
    assert.ok(difference(before, await client.picture()) < 0.5, "what is inside is seen");
    await client.keep("first-volume");
    await undo();
  });

  test("an array that is shown already is shown on the same scale: one legend", async () => {
    await rpc("scene.patch", { patch: { layers: { iso: { color: { map: "magma", range: [1, 9] } } } } });
    await client.settled();
    const card = await sliceCard();
    await card.getByLabel("Color by").selectOption("U:magnitude");
    assert.deepEqual((await layers()).slice?.color, { array: "U:magnitude", map: "magma", range: [1, 9] });
    assert.equal(await client.page.locator(".legend").count(), 1);
    await undo();
    await undo();
  });

  test("a legend's name is one line with its units in brackets, as in a picture; its range says of what it is", async () => {
    const legend = client.page.getByLabel("Colors of U:magnitude");
    assert.equal(await legend.getAttribute("title"), "U:magnitude [R/T]");
    assert.equal(await client.page.locator(".texts text", { hasText: /^U:magnitude \[R\/T\]$/ }).count(), 1);
    const of = legend.locator(".range-of");
    assert.equal(await of.textContent(), "this step");
    const pin = legend.getByRole("button", { name: "The same range at every step" });
    assert.match((await pin.getAttribute("title")) ?? "", /lowest and the highest value of this step/);
    await pin.click();
    await client.settled();
    assert.equal(await of.textContent(), "all steps");
    const high = legend.getByLabel(/^Highest value/);
    assert.match((await high.getAttribute("title")) ?? "", /Type another/);
    await high.fill("5");
    await high.press("Enter");
    await client.settled();
    assert.equal(await of.textContent(), "held");
    await client.keep("legend-held");
    await undo();
    await undo();
  });

  test("a range of most values leaves single points out", async () => {
    const card = await sliceCard();
    await card.getByRole("button", { name: /^Color scale of/ }).click();
    client.patches.length = 0;
    await card.getByRole("button", { name: "1–99 %" }).click();
    await client.patched();
    const [low, high] = (await layers()).slice?.color?.range ?? [NaN, NaN];
    const legend = client.page.getByLabel("Colors of vorticity");
    assert.equal(await legend.locator(".range-of").textContent(), "held");
    assert.ok(low > -49.3 && low < 0 && high < 49.3 && high > 0, `${low} to ${high}`);
    await client.keep("percentiles");
    await undo();
  });

  test("export offers the layer that was touched last", async () => {
    const offered = async (): Promise<string> => {
      await client.button("Export a surface").click();
      const value = await client.page.getByLabel("Surface", { exact: true }).inputValue();
      await client.page.keyboard.press("Escape");
      return value;
    };
    await sliceCard();
    for (const [id, name] of [
      ["slice", /^Slice at/],
      ["iso", /^Iso-surface of/],
      ["slice", /^Slice at/],
    ] as const) {
      const opacity = client.page.getByRole("article", { name }).getByLabel("Opacity", { exact: true });
      await opacity.press("ArrowLeft");
      await client.settled();
      assert.equal(await offered(), id);
    }
    for (let i = 0; i < 3; i += 1) await undo();
  });

  test("HD, 4K and A4 are sizes of pictures", async () => {
    await client.button("Pictures of other sizes").click();
    for (const [name, width, height] of [
      ["HD", "1920", "1080"],
      ["4K", "3840", "2160"],
      ["A4", "3508", "2480"],
    ] as const) {
      await client.button(name, true).click();
      assert.equal(await client.page.getByLabel("Width of the picture in pixels").inputValue(), width);
      assert.equal(await client.page.getByLabel("Height of the picture in pixels").inputValue(), height);
    }
    await client.button("Pictures of other sizes").click();
  });

  test("a picture tells how far it is, and is given up by Cancel", async () => {
    await client.page.evaluate(() => {
      const words = new Set<string>();
      Object.assign(window, { heardWords: words });
      new MutationObserver(() => {
        words.add(document.querySelector(".busy")?.textContent ?? "");
      }).observe(document.body, { subtree: true, childList: true, characterData: true });
    });
    const [saved] = await Promise.all([
      client.page.waitForEvent("download"),
      client.button("Save a picture").first().click(),
    ]);
    assert.match(saved.suggestedFilename(), /\.png$/);
    const heard = await client.page.evaluate(() => [...(window as unknown as { heardWords: Set<string> }).heardWords]);
    assert.ok(heard.includes("Drawing the picture: drawingCancel"), heard.join("; "));

    stage.server.pause();
    await client.button("Save a picture").first().click();
    await client.page.locator(".busy", { hasText: "Drawing the picture" }).waitFor();
    await client.keep("picture-to-cancel");
    await client.button("Cancel", true).click();
    await client.page.locator(".busy", { hasText: "Drawing the picture" }).waitFor({ state: "detached" });
    assert.equal(await client.page.locator(".toast").count(), 0);
    stage.server.goOn();
    await client.connected();
    await client.settled();
  });

  test("the values of a probe are copied with all their digits", async () => {
    await client.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    const box = await client.canvas.boundingBox();
    await client.canvas.click({ position: { x: (box?.width ?? 0) / 2, y: (box?.height ?? 0) / 2 } });
    await client.button("Copy the values").click();
    await client.toast("The values are in the clipboard").waitFor();
    const text = await client.page.evaluate(() => navigator.clipboard.readText());
    assert.match(text, /^dataset\t/);
    assert.match(text, /\nU:magnitude\t\d+\.\d{4,}\t/);
    await client.button("Close the values").click();
  });

  test("a dropped file is answered with what to do, and the page stays", async () => {
    const address = client.page.url();
    await client.page.evaluate(() => {
      const files = new DataTransfer();
      files.items.add(new File(["x"], "wing.vtu"));
      for (const type of ["dragover", "drop"])
        document.body.dispatchEvent(new DragEvent(type, { dataTransfer: files, bubbles: true, cancelable: true }));
    });
    await client.toast(/ciel import wing\.vtu -o wing\.ciel/).waitFor();
    assert.equal(client.page.url(), address);
  });

  test("help is readable in a window of 900 pixels", async () => {
    await client.page.setViewportSize({ width: 900, height: 700 });
    await client.canvas.focus();
    await client.page.keyboard.press("?");
    await client.page.getByRole("dialog").waitFor();
    const rows = client.page.locator(".help dl > div");
    const narrow = await rows.evaluateAll((all) =>
      all
        .map((row) => [...row.children].map((cell) => cell.getBoundingClientRect().width))
        .filter((cells) => cells.some((width) => width < 120)),
    );
    assert.deepEqual(narrow, []);
    const box = await client.page.getByRole("dialog").boundingBox();
    assert.ok((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 901) <= 900);
    await client.keep("help-900");
    await client.page.keyboard.press("Escape");
    await client.page.setViewportSize({ width: 1280, height: 800 });
  });

  test("nothing went wrong on the way", () => assert.deepEqual(client.problems, []));
});
