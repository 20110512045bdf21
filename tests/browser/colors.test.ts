// Tests that each control of a color scale changes the surface and the legend, in both streams.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference, distance, share, type Color } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const scene = {
  dataset: nameOf(data[0] ?? ""),
  background: "#000000",
  camera: { position: [5, 0, 40], target: [5, 0, 0], up: [0, 1, 0] },
  layers: { s: { type: "slice", axis: "z", value: 2.4, color: { array: "U:magnitude", map: "grayscale" } } },
};

describe("colors", { skip }, () => {
  const stage = new Stage();
  let client: Client;
  before(async () => {
    client = await stage.fresh({ width: 1280, height: 900 }, fragmentOf(scene));
    await client.button("Color scale of U:magnitude").click();
  });

  const check = (name: string): ReturnType<Client["page"]["getByLabel"]> =>
    client.page.getByLabel(name, { exact: true });
  /** Performs an action, checks that it is one undo step, and returns the picture after it. */
  const after = async (act: () => Promise<unknown>): Promise<Awaited<ReturnType<Client["picture"]>>> => {
    client.patches.length = 0;
    await act();
    await client.patched();
    await client.settled();
    assert.equal(new Set(client.patches.map(({ gesture }) => gesture)).size, 1, "one step of undo");
    return client.picture();
  };
  const undo = async (): Promise<void> => {
    await client.button("Undo").click();
    await client.settled();
  };
  const like =
    (wanted: Color, tolerance = 6) =>
    (color: Color): boolean =>
      distance(color, wanted) < tolerance;
  const labels = (): Promise<string[]> =>
    client.page.locator(".texts text", { hasText: /^[\u2212\d.]+$/ }).allTextContents();

  test("a swatch chooses the map, and undo takes it back", async () => {
    const grey = await client.picture();
    const colored = await after(() => client.button("Color map inferno").click());
    assert.equal(await check("Map").inputValue(), "inferno");
    assert.ok(difference(grey, colored) > 0.05);
    await undo();
    assert.ok(difference(grey, await client.picture()) < 0.002);
    assert.equal(await check("Map").inputValue(), "grayscale");
  });

  test("reversed, dark is light", async () => {
    const plain = await client.picture();
    const reversed = await after(() => check("Reverse").check());
    const turned = share(plain, (color, x, y) => Math.abs(color[0] + reversed.at(x, y)[0] - 255) <= 3);
    assert.ok(turned > 0.35, `${turned} of the picture is turned; the slice is more`);
    await after(() => check("Reverse").uncheck());
  });

  test("a logarithm spreads the small values, and the legend counts in powers of ten", async () => {
    const linear = await client.picture();
    const dark = (color: Color): boolean => color[0] < 40;
    const logarithmic = await after(() => check("Logarithmic").check());
    assert.ok(share(logarithmic, dark) < share(linear, dark));
    await client.keep("colors_log");
    assert.ok((await labels()).includes("0.001"), (await labels()).join());
    await after(() => check("Symmetric").check());
    assert.equal(await check("Logarithmic").isChecked(), false, "one excludes the other");
    const low = await client.page.getByLabel(/^Lowest value of/).inputValue();
    const high = await client.page.getByLabel(/^Highest value of/).inputValue();
    assert.equal(low, `\u2212${high}`);
    await after(() => check("Symmetric").uncheck());
    assert.ok(difference(linear, await client.picture()) < 0.002);
  });

  test("steps have sharp bounds and no colors but their own", async () => {
    await after(() => check("Steps").check());
    await after(async () => {
      await check("Number of steps").fill("3");
      await check("Number of steps").press("Enter");
    });
    const picture = await client.picture();
    const flat = (color: Color): boolean =>
      (
        [
          [128, 128, 128],
          [255, 255, 255],
        ] as Color[]
      ).some((own) => like(own)(color));
    assert.ok(share(picture, flat) > 0.1);
    const grey = (color: Color): boolean => color[0] > 12 && color[0] < 243 && !flat(color);
    assert.ok(share(picture, grey) < 0.03, "between the steps are their bounds alone");
    assert.equal((await labels()).length, 4, "three steps have four bounds");
    await client.keep("colors_steps");
    await after(() => check("Steps").uncheck());
  });

  test("values outside a typed range have their own colors, in both streams alike", async () => {
    await after(async () => {
      await check("Range to").fill("15");
      await check("Range to").press("Enter");
    });
    await after(async () => {
      await check("Range from").fill("5");
      await check("Range from").press("Enter");
    });
    await after(() => check("Below the range").check());
    await after(() => check("Above the range").check());
    for (const [name, color] of [
      ["Color of values below the range", "#0000ff"],
      ["Color of values above the range", "#ff0000"],
    ] as const)
      await after(() => check(name).fill(color));
    const picture = await client.picture();
    assert.ok(share(picture, like([0, 0, 255], 3)) > 0.005, "nothing is blue");
    assert.ok(share(picture, like([255, 0, 0], 3)) > 0.005, "nothing is red");
    for (const ink of ["rgb(0 0 255 / 1)", "rgb(255 0 0 / 1)"])
      assert.equal(await client.page.locator(`.texts .fill[fill="${ink}"]`).count(), 1, ink);
    await client.keep("colors_outside");
    await after(() => check("Logarithmic").check());
    await after(() => client.button("Color map batlow").click());
    await after(() => check("Reverse").check());
    const image = await client.picture();
    await client.page.getByLabel("Stream").selectOption("geometry");
    await client.settled("geometry");
    const geometry = await client.picture();
    await client.keep("colors_geometry");
    assert.ok(difference(image, geometry) < 0.01, `${difference(image, geometry)} differ`);
    await check("Steps").check();
    await client.page.waitForTimeout(500);
    await client.settled("geometry");
    const stepped = await client.picture();
    await client.page.getByLabel("Stream").selectOption("image");
    await client.settled();
    assert.ok(difference(stepped, await client.picture()) < 0.01, "in steps, too");
    assert.ok(difference(stepped, image) > 0.01);
  });

  test("a logarithmic range is not typed below zero: a sentence says so", async () => {
    await check("Range from").fill("-1");
    await check("Range from").press("Enter");
    await client.toast(/begins above zero/).waitFor();
    await after(() => client.page.getByRole("button", { name: "Data", exact: true }).first().click());
  });

  test("the range in view is that of what one sees", async () => {
    await after(() => check("Logarithmic").uncheck());
    const high = async (): Promise<number> => Number(await check("Range to").inputValue());
    const whole = await high();
    await client.canvas.focus();
    for (let i = 0; i < 14; i += 1) await client.page.keyboard.press("+");
    await client.settled();
    await after(() => client.button("In view").click());
    assert.ok((await high()) < whole, `${await high()} of ${whole}`);
  });

  test("colors of one's own are moved by keys", async () => {
    const before = await after(() => check("Colors of my own").check());
    await client.page.getByLabel("Place of color 3").focus();
    const moved = await after(async () => {
      await client.page.keyboard.press("PageUp");
    });
    assert.ok(difference(before, moved) > 0.001);
    assert.equal(await client.page.getByLabel("Place of color 3").getAttribute("aria-valuenow"), "60");
    await after(() => client.button("Remove color 2").click());
    assert.equal(await client.page.getByRole("slider", { name: /^Place of color/ }).count(), 4);
    await client.keep("colors_points");
    await undo();
    await after(() => check("Map").selectOption("vik"));
    assert.equal(await check("Colors of my own").isChecked(), false);
  });

  test("nothing went wrong on the way", () => assert.deepEqual(client.problems, []));
});
