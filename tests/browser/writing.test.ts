// What is written over the view, and the controls that came with volumes and free planes.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import { difference } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

describe("writing", { skip }, () => {
  const stage = new Stage({ width: 1280, height: 720 });
  const dataset = nameOf(data[0] ?? "");
  const annotations = { axes: true, dataset: true, title: "Legible" };
  const linked = (scene: object): string => fragmentOf({ dataset, ...scene });
  const luma = (css: string): number => {
    const [r = 0, g = 0, b = 0] = (css.match(/[\d.]+/g) ?? []).map(Number);
    return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
  };

  for (const [scheme, background, dark] of [
    ["light", "dark", false],
    ["dark", "light", true],
    ["dark", "#ffee00", true],
    ["light", "#101030", false],
  ] as const) {
    test(`is legible on ${background} with the ${scheme} theme`, async () => {
      const client = await stage.fresh({ scheme }, linked({ background, annotations }));
      const title = client.page.locator(".captions h2");
      const color = await title.evaluate((element) => getComputedStyle(element).color);
      const stroke = await client.page.locator(".box-axes").evaluate((element) => getComputedStyle(element).stroke);
      for (const css of [color, stroke]) assert.ok(dark ? luma(css) < 0.3 : luma(css) > 0.7, `${css} on ${background}`);
      await client.keep(`writing-${background.replace("#", "")}-${scheme}`);
      await client.close();
    });
  }

  test("stands around the box of a link without a camera, and follows the size of text", async () => {
    const client = await stage.fresh({}, linked({ background: "dark", annotations }));
    const numbers = client.page.locator(".box-axes text");
    await numbers.first().waitFor();
    assert.ok((await numbers.count()) >= 9, "three names and two numbers each at least");
    const height = async (): Promise<number> => (await client.page.locator(".captions h2").boundingBox())?.height ?? 0;
    const before = await height();
    const slider = client.page.getByRole("slider", { name: "Text size" });
    await slider.focus();
    for (let i = 0; i < 10; i += 1) await slider.press("ArrowRight");
    await client.settled();
    assert.ok(Math.abs((await height()) / before - 2) < 0.1, "twice as large at 200 %");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("of a legend shows the number itself while it is typed", async () => {
    const layers = { s: { type: "surface", color: { array: "tracer", range: [0, 0.123456] } } };
    const client = await stage.fresh({}, fragmentOf({ dataset, layers }));
    const field = client.page.getByRole("textbox", { name: /^Highest value/ });
    assert.equal(await field.inputValue(), "0.123");
    await field.focus();
    assert.equal(await field.inputValue(), "0.12346");
    await field.press("Escape");
    assert.equal(client.patches.length, 0, "looking is no change");
    await client.close();
  });

  test("a free slice plane is added, moved along its normal, turned to the view, and taken away", async () => {
    const client = await stage.fresh();
    const before = await client.picture();
    await client.button("Add a free slice plane").click();
    await client.settled();
    const added = await client.picture();
    assert.ok(difference(before, added) > 0.01);
    const slider = client.page.getByRole("slider", { name: "Position along the normal" });
    await slider.focus();
    await slider.press("PageUp");
    await client.settled();
    const moved = await client.picture();
    assert.ok(difference(added, moved) > 0.005);
    await client.button("Turn the plane to face the view").click();
    await client.settled();
    assert.ok(difference(moved, await client.picture()) > 0.01);
    await client.button("Remove this plane").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.001);
    const panel = client.page.locator(".side-panel");
    assert.ok(
      await panel.evaluate((element) => element.scrollWidth <= element.clientWidth),
      "the panel is wide enough",
    );
    await client.close();
  });

  test("a volume alone is something that is seen, and has a scale of its own", async () => {
    const client = await stage.fresh();
    await client.button("Hide this iso-surface").click();
    await client.button("Add a volume").click();
    await client.settled();
    await client.page.waitForTimeout(300);
    assert.equal(await client.page.getByText("None of the surfaces").count(), 0);
    const plain = await client.picture();
    const volume = client.page.getByRole("article", { name: /^Volume of/ });
    await volume.getByRole("button", { name: /^Colour scale of/ }).click();
    await volume.getByRole("checkbox", { name: "Reverse" }).check();
    await client.settled();
    assert.ok(difference(plain, await client.picture()) > 0.01);
    await client.page.keyboard.press("Control+z");
    await client.settled();
    assert.ok(difference(plain, await client.picture()) < 0.002);
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
