// Tests the picture in both streams, and that gestures change it.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { lateAnswer } from "./late_answer.ts";
import { changedLayer, type Client } from "./page.ts";
import { difference, distance, find, hue, share, type Color, type Picture } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

/**
 * Share of pixels that differ from the background. The color of the background depends only on the row. It is read at
 * the left edge of the row.
 */
const foreground = (picture: Picture): number =>
  share(picture, (color, _x, y) => distance(color, picture.at(1, y)) > 10);

type Vector = [number, number, number];

/** Returns the vector from the camera's target to its position. */
function fromTarget(camera: unknown): Vector {
  const { position, target } = camera as { position: Vector; target: Vector };
  return [position[0] - target[0], position[1] - target[1], position[2] - target[2]];
}
const isColored = (color: Color): boolean => hue(color) !== null;

describe("view", { skip }, () => {
  const stage = new Stage({ width: 1280, height: 720 }, { large: true }); // large enough for several batches and pieces
  let client: Client;
  before(async () => {
    client = await stage.same();
  });

  test("the first picture shows something on a background", async () => {
    await client.keep("first");
    const picture = await client.picture();
    const part = foreground(picture);
    assert.ok(part > 0.02 && part < 0.9, `${part} of the picture is not background`);
    assert.ok(distance(picture.at(4, 4), [26, 31, 41]) < 12, `the top left is ${picture.at(4, 4).join()}`);
    assert.ok(share(picture, isColored) > 0.01, "no color of a map is seen");
  });

  test("a drag over the canvas turns the view and is one step of undo", async () => {
    const before = await client.picture();
    client.patches.length = 0;
    await client.dragCanvas([0.5, 0.5], [0.7, 0.4]);
    await client.settled();
    const turned = await client.picture();
    assert.ok(difference(before, turned) > 0.02);
    const [first, last] = [client.patches[0], client.patches.at(-1)].map((sent) => fromTarget(sent?.patch.camera));
    assert.ok(first !== undefined && last !== undefined);
    assert.ok(first[0] * last[1] < first[1] * last[0], "the camera goes to the left, as the data goes to the right");
    assert.ok(last[2] < first[2], "the camera goes down, as the data goes up");
    assert.ok(Math.abs(Math.hypot(...last) / Math.hypot(...first) - 1) < 1e-3, "the camera keeps its distance");
    await client.button("Undo").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005, "one undo brings the view back");
    await client.button("Redo").click();
    await client.settled();
    assert.ok(difference(turned, await client.picture()) < 0.005, "redo turns it again");
    await client.button("Undo").click();
    await client.settled();
  });

  test("a drag of the iso-value changes the picture and is one step of undo", async () => {
    const before = await client.picture();
    const value = await client.value();
    client.patches.length = 0;
    await client.dragIso(0.75);
    await client.settled();
    assert.notEqual(await client.value(), value);
    assert.ok(difference(before, await client.picture()) > 0.01);
    assert.ok(client.patches.length > 0 && client.patches.length <= 13, `${client.patches.length} patches`);
    assert.equal(new Set(client.patches.map(({ gesture }) => gesture)).size, 1);
    await client.page.keyboard.press("Control+z");
    await client.settled();
    assert.equal(await client.value(), value);
    assert.ok(difference(before, await client.picture()) < 0.005);
    await client.page.keyboard.press("Control+Shift+Z");
    await client.settled();
    assert.notEqual(await client.value(), value);
    await client.button("Undo").click();
    await client.settled();
  });

  test("the iso-value by keyboard and by typing", async () => {
    const value = await client.value();
    await client.isoValue.focus();
    await client.page.keyboard.press("PageUp");
    await client.settled();
    const paged = await client.value();
    assert.ok(paged > value);
    const field = client.page.getByLabel("Iso-value", { exact: true });
    await field.fill(String(value));
    await field.press("Enter");
    await client.settled();
    assert.equal(await client.value(), value);
    await field.fill("not a number");
    await field.press("Enter");
    assert.equal(await client.value(), value);
  });

  test("the wheel zooms to the cursor, R shows everything again", async () => {
    await client.canvas.focus(); // a focused field would use the keys itself
    client.patches.length = 0;
    await client.page.keyboard.press("r");
    await client.patched();
    await client.settled();
    const before = await client.picture();
    const box = await client.canvas.boundingBox();
    await client.page.mouse.move((box?.x ?? 0) + 480, (box?.y ?? 0) + 300);
    for (let i = 0; i < 4; i += 1) await client.page.mouse.wheel(0, -120);
    await client.settled();
    const near = await client.picture();
    assert.ok(foreground(near) > 1.2 * foreground(before), "what is drawn has become larger");
    await client.canvas.focus();
    client.patches.length = 0;
    await client.page.keyboard.press("r");
    await client.patched();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("axis views and the projection", async () => {
    const before = await client.picture();
    await client.button("Look from plus z").click();
    await client.settled();
    const fromAbove = await client.picture();
    assert.ok(difference(before, fromAbove) > 0.02);
    const coordinate = async (name: string): Promise<string> =>
      client.page.getByLabel(name, { exact: true }).inputValue();
    for (const axis of ["x", "y"])
      assert.equal(
        await coordinate(`Position ${axis}`),
        await coordinate(`Target ${axis}`),
        `not beside it in ${axis}`,
      );
    client.patches.length = 0;
    await client.page.getByLabel("Parallel projection").check();
    await client.settled();
    assert.equal((client.patches.at(-1)?.patch as { camera: { parallel: boolean } }).camera.parallel, true);
    assert.ok(difference(fromAbove, await client.picture()) > 0.001);
    await client.page.getByLabel("Parallel projection").uncheck();
    await client.button("Show what is drawn").click();
    await client.settled();
  });

  test("the field of view changes the perspective, not the size, and is one step of undo", async () => {
    const before = await client.picture();
    client.patches.length = 0;
    const slider = client.page.getByLabel("Field of view", { exact: true });
    await slider.focus();
    for (let i = 0; i < 4; i += 1) await client.page.keyboard.press("PageUp"); // wider: near parts grow
    await client.settled();
    const strong = await client.picture();
    assert.ok(difference(before, strong) > 0.005);
    assert.ok(Math.abs(foreground(strong) / foreground(before) - 1) < 0.5, "all of it is still seen");
    const degrees = client.page.getByLabel("Field of view in degrees");
    assert.ok(Number(await degrees.inputValue()) > 60);
    const height = await client.page.getByLabel("Height of the view").inputValue();
    await degrees.fill("30");
    await degrees.press("Enter");
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005, "30 degrees look as they did");
    assert.equal(await client.page.getByLabel("Height of the view").inputValue(), height);
    await degrees.fill("500");
    await degrees.press("Enter");
    assert.equal(await degrees.inputValue(), "120", "as wide as a hand can have it");
    await client.settled();
    await client.button("Undo").click();
    await client.settled();
    assert.equal(await degrees.inputValue(), "30");
    const from = client.page.getByLabel("Position x");
    const at = Number((await from.inputValue()).replace("\u2212", "-"));
    await from.fill(String(at + 1));
    await from.press("Enter");
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.002);
    await client.button("Undo").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("a slice appears, moves and goes", async () => {
    const before = await client.picture();
    client.patches.length = 0;
    await client.button("Add a slice across x").click();
    await client.settled();
    const sliced = await client.picture();
    await client.keep("slice");
    assert.ok(difference(before, sliced) > 0.01);
    await client.page.getByLabel("Position of the x slice").focus();
    for (let i = 0; i < 3; i += 1) await client.page.keyboard.press("PageUp");
    await client.settled();
    const [added, moved] = [client.patches[0], client.patches.at(-1)].map(changedLayer);
    assert.deepEqual([added?.type, added?.axis, Object.keys(moved ?? {})], ["slice", "x", ["value"]]);
    assert.ok(Number(moved?.value) > Number(added?.value), JSON.stringify([added, moved]));
    assert.ok(difference(sliced, await client.picture()) > 0.005);
    await client.button("Remove this slice").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("another color map changes hues, not the silhouette", async () => {
    const before = await client.picture();
    const map = client.page.getByLabel("Map", { exact: true }).first();
    const old = await map.inputValue();
    await map.selectOption("grayscale");
    await client.settled();
    const grey = await client.picture();
    assert.ok(share(grey, isColored) < share(before, isColored) / 2, "grey takes the hues away");
    assert.ok(Math.abs(foreground(grey) - foreground(before)) < 0.03);
    await map.selectOption(old);
    await client.settled();
  });

  test("the legend's range is edited and reset", async () => {
    const low = client.page.getByLabel(/^Lowest value of/).first();
    const high = client.page.getByLabel(/^Highest value of/).first();
    const old = [await low.inputValue(), await high.inputValue()];
    const before = await client.picture();
    await high.fill(String(Number(old[0]?.replace("\u2212", "-")) + 1e-6));
    await high.press("Enter");
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.005);
    await client
      .button(/^Range of the data/)
      .first()
      .click();
    await client.settled();
    assert.deepEqual([await low.inputValue(), await high.inputValue()], old);
  });

  test("axes of the box, title and time are written over the frames, not into them", async () => {
    const before = await client.picture();
    const axes = client.page.getByLabel("Axes of the bounding box");
    assert.equal(await axes.count(), 0);
    await client.page.getByLabel("Axes of the box").check();
    await axes.locator("text").first().waitFor();
    assert.ok((await axes.locator("text").count()) > 5, "numbers and names");
    await client.page.getByLabel("Title").fill("Wake, \u00b5");
    await client.page.getByLabel("Title").press("Enter");
    await client.page.locator(".texts text", { hasText: "Wake, \u00b5" }).waitFor();
    await client.page.getByRole("checkbox", { name: "Time", exact: true }).check();
    await client.page.locator(".texts text", { hasText: "Time: " }).waitFor();
    await client.settled();
    await client.keep("annotations");
    assert.ok(difference(before, await client.picture()) < 0.005);
    for (let step = 0; step < 3; step += 1) await client.button("Undo").click();
    await client.settled();
    const captions = client.page.locator(".texts text", { hasText: /^Wake|^Time/ });
    assert.equal((await axes.count()) + (await captions.count()), 0, "each is a step of undo");
  });

  test("a click reads the values, a double click centers", async () => {
    const picture = await client.picture();
    const [x, y] = find(
      picture,
      (color, px, py) => isColored(color) && px > picture.width * 0.4 && py > picture.height * 0.4,
    );
    await client.canvas.click({ position: { x: x + 2, y: y + 2 } });
    const card = client.page.getByLabel("Values at the clicked point");
    await card.waitFor();
    assert.match((await card.textContent()) ?? "", /\d/);
    await client.keep("probe");
    client.patches.length = 0;
    await client.canvas.dblclick({ position: { x: x + 2, y: y + 2 } });
    await client.patched();
    await client.settled();
    assert.ok(difference(picture, await client.picture()) > 0.005);
    await client.button("Close the values").click();
    await client.button("Show what is drawn").click();
    await client.settled();
  });

  test("the geometry stream draws the same silhouette", async () => {
    const image = await client.picture();
    await client.page.getByLabel("Stream").selectOption("geometry");
    await client.settled("geometry");
    const geometry = await client.picture();
    await client.keep("geometry");
    const [a, b] = [foreground(image), foreground(geometry)];
    assert.ok(Math.abs(a - b) < 0.02, `${a} of the image and ${b} of the geometry are not background`);
    assert.ok(difference(image, geometry) < 0.08, `${difference(image, geometry)} differ`);
    client.patches.length = 0;
    await client.dragCanvas([0.5, 0.5], [0.6, 0.5]);
    assert.ok(difference(geometry, await client.picture()) > 0.01, "the camera answers without the server");
    await client.button("Undo").click();
    await client.page.getByLabel("Stream").selectOption("image");
    await client.settled();
    assert.ok(difference(image, await client.picture()) < 0.005);
  });

  test("polygons that come before the answer to view.open are shown", async () => {
    const early = await stage.open(stage.server.address, {
      before: `${lateAnswer}; localStorage.setItem("ciel.stream", "geometry")`,
    });
    await early.settled("geometry");
    assert.ok(foreground(await early.picture()) > 0.02);
    assert.deepEqual(early.problems, []);
    await early.close();
  });

  test("nothing went wrong on the way", () => assert.deepEqual(client.problems, []));

  test("every dataset opens", async () => {
    for (const path of data) {
      await client.choose(nameOf(path));
      await client.settled();
      await client.keep(`dataset-${nameOf(path)}`);
      const part = foreground(await client.picture());
      assert.ok(part > 0.01 && part < 0.95, `${nameOf(path)}: ${part} of the picture is not background`);
    }
  });
});
