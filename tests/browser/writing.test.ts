// Tests the texts over the view, and the controls of volumes and free planes.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import { decodePng, difference, type Color } from "./png.ts";
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
      const layers = { s: { type: "surface", color: { array: "tracer" } } };
      const client = await stage.fresh({ scheme }, linked({ background, annotations, layers }));
      const axes = client.page.locator(".box-axes text").first();
      const ink = await axes.evaluate((element) => getComputedStyle(element).fill);
      const inks = await client.page
        .locator(".texts text")
        .evaluateAll((all) => all.map((element) => getComputedStyle(element).fill));
      assert.ok(inks.length > 5, "title, dataset and a legend with its numbers");
      const words = await client.page.locator(".range-of").evaluate((element) => getComputedStyle(element).color);
      for (const css of [ink, words, ...inks])
        assert.ok(dark ? luma(css) < 0.3 : luma(css) > 0.7, `${css} on ${background}`);
      await client.keep(`writing-${background.replace("#", "")}-${scheme}`);
      await client.close();
    });
  }

  const linear = (channel: number): number =>
    channel <= 10 ? channel / 255 / 12.92 : ((channel / 255 + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]: Color): number => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);

  // WCAG 2.1, 1.4.3: contrast of the letters to their surroundings, which fill most of a text's box.
  for (const [background, solid] of [
    ["dark", "#ffffff"],
    ["dark", "#808080"],
    ["light", "#000000"],
    ["light", "#808080"],
  ] as const) {
    test(`has a contrast of 4.5 over a picture in ${solid} on ${background}`, async () => {
      const wall = { type: "surface", color: { solid } };
      const lighting = { on: false };
      const client = await stage.fresh(
        {},
        linked({ background, annotations: { ...annotations, time: true }, lighting, layers: { wall } }),
      );
      for (let i = 0; i < 7; i += 1) await client.page.keyboard.press("+"); // the wall fills the picture
      await client.settled();
      const boxes = await client.page
        .locator(".texts text, .box-axes text")
        .evaluateAll((all) => all.map((element) => element.getBoundingClientRect().toJSON() as DOMRect));
      const shot = decodePng(await client.page.screenshot());
      const contrasts = boxes.map(({ left, top, right, bottom }) => {
        const found: number[] = [];
        for (let y = Math.ceil(top); y < bottom; y += 1)
          for (let x = Math.ceil(left); x < right; x += 1) found.push(luminance(shot.at(x, y)));
        found.sort((a, b) => (background === "dark" ? b - a : a - b));
        const share = (of: number): number => found[Math.floor(of * found.length)] ?? NaN;
        const [letters, around] = [share(0.03), share(0.6)];
        return (Math.max(letters, around) + 0.05) / (Math.min(letters, around) + 0.05);
      });
      await client.keep(`contrast-${background}-${solid.slice(1)}`);
      const captions = await client.page.locator(".texts text").count();
      const ofAxes = await client.page.locator(".box-axes text").count();
      assert.ok(captions === 3 && ofAxes >= 1, `${captions} captions, ${ofAxes} texts of axes`);
      for (const contrast of contrasts) assert.ok(contrast >= 4.5, contrasts.map((one) => one.toFixed(1)).join(" "));
      await client.close();
    });
  }

  test("stands around the box of a link without a camera, and follows the size of text", async () => {
    const client = await stage.fresh({}, linked({ background: "dark", annotations }));
    const numbers = client.page.locator(".box-axes text");
    await numbers.first().waitFor();
    assert.ok((await numbers.count()) >= 9, "three names and two numbers each at least");
    const caption = client.page.locator(".texts text").nth(1);
    const height = (): Promise<number> => caption.evaluate((element) => element.getBoundingClientRect().height);
    const before = await height();
    const slider = client.page.getByRole("slider", { name: "Text size" });
    await slider.focus();
    for (let i = 0; i < 10; i += 1) await slider.press("ArrowRight");
    await client.settled();
    const after = await height();
    assert.ok(Math.abs(after / before - 2) < 0.1, `${before} to ${after} pixels, not twice as large at 200 %`);
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  for (const [width, height, most, share] of [
    [1280, 800, 140, 0.085], // wide enough for a name with units
    [700, 420, 90, 0.16],
    [360, 640, 90, 0.2],
  ] as const)
    test(`of two legends takes no more of ${width} x ${height} than it needs`, async () => {
      const of = (axis: string, array: string): object => ({ type: "slice", axis, value: 2, color: { array } });
      const layers = { a: of("x", "tracer"), b: of("y", "U:magnitude") };
      const client = await stage.fresh({ width, height }, linked({ layers, background: "light" }));
      const area = await client.canvas.boundingBox();
      const boxes = await client.page
        .locator(".legend")
        .evaluateAll((all) => all.map((element) => element.getBoundingClientRect().toJSON() as DOMRect));
      await client.keep(`legends-${width}`);
      const taken = boxes.reduce((sum, box) => sum + box.width * box.height, 0);
      assert.equal(boxes.length, 2);
      assert.ok(Math.max(...boxes.map((box) => box.width)) <= most, JSON.stringify(boxes));
      assert.ok(taken <= share * (area?.width ?? 0) * (area?.height ?? 0), JSON.stringify(boxes));
      const texts = await client.page
        .locator(".texts text")
        .evaluateAll((all) => all.map((element) => element.getBoundingClientRect().toJSON() as DOMRect));
      const inside = (text: DOMRect, box: DOMRect): boolean =>
        text.left >= box.left - 2 &&
        text.right <= box.right + 2 &&
        text.top >= box.top - 2 &&
        text.bottom <= box.bottom + 2;
      for (const text of texts)
        assert.ok(
          boxes.some((box) => inside(text, box)),
          "each text is within its legend",
        );
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
    await client.button("Remove this slice").click();
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
    assert.equal(await client.page.locator(".lacking").count(), 0);
    const plain = await client.picture();
    const volume = client.page.getByRole("article", { name: /^Volume of/ });
    await volume.getByRole("button", { name: /^Color scale of/ }).click();
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
