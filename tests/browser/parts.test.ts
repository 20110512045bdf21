// Tests parts of layers with their own controls: contour lines and their scale, patches, further layers of one type.
// Also tests pictures in other sizes than the view.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, test } from "node:test";
import { fragmentOf, sceneOf } from "./link.ts";
import type { Client } from "./page.ts";
import { decodePng, difference, distance, share, type Color, type Picture } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const dataset = nameOf(data[0] ?? "");
interface Contours {
  array: string;
  values?: number[];
  range?: number[];
  coloring?: { range?: number[] };
}

const camera = { position: [5, 0, 40], target: [5, 0, 0], up: [0, 1, 0] } as const;
const slice = { type: "slice", color: { array: "U:magnitude" } };

describe("parts of layers", { skip }, () => {
  const stage = new Stage();
  const opened = (layers: object): Promise<Client> =>
    stage.fresh({ width: 1280, height: 900 }, fragmentOf({ dataset, camera, layers }));
  const layers = async (client: Client): Promise<Record<string, { contours?: Contours }>> => {
    await client.addressed();
    return (sceneOf(client.page.url()) as { layers: Record<string, { contours?: Contours }> }).layers;
  };
  const type = async (client: Client, label: string, text: string): Promise<void> => {
    await client.page.getByLabel(label, { exact: true }).fill(text);
    await client.page.keyboard.press("Enter");
    await client.settled();
  };
  const legends = (client: Client): Promise<string[]> =>
    client.page.locator(".legend").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label") ?? ""));

  test("contour lines in the colors of their values have a legend, a scale and a range of their own", async () => {
    const client = await opened({
      a: { ...slice, axis: "z", value: 2.4, contours: { array: "vorticity", width: 3 } },
    });
    assert.deepEqual(await legends(client), ["Colors of U:magnitude"]);
    const plain = await client.picture();
    await client.page.getByLabel("Lines in the colors of their values").check();
    await client.settled();
    assert.deepEqual(await legends(client), ["Colors of U:magnitude", "Colors of vorticity"]);
    assert.ok(difference(plain, await client.picture()) > 0.001, "lines of other colors");
    await client.button("Color scale of the lines of vorticity").click();
    await client.button("In view").click();
    await client.patched(2);
    await client.settled();
    const { a } = await layers(client);
    const [low, high] = a?.contours?.coloring?.range ?? [];
    const highest = Number(await client.page.getByLabel("Highest value of the U:magnitude colors").inputValue());
    assert.ok(low !== undefined && high !== undefined && low < high);
    assert.notEqual(high.toFixed(1), highest.toFixed(1), "of the lines, not of the slice");
    await client.keep("contours_scale");
    assert.deepEqual(client.problems, []);
    assert.equal(await client.page.locator(".toast").count(), 0);
    await client.close();
  });

  test("contour lines at values of one's own, between others, and of another array", async () => {
    const client = await opened({
      a: {
        ...slice,
        axis: "z",
        value: 2.4,
        contours: { array: "vorticity", count: 4, coloring: { array: "vorticity" } },
      },
    });
    const contours = async (): Promise<Contours | undefined> => (await layers(client)).a?.contours;
    await client.page.getByLabel("Lines at").selectOption("own");
    await client.settled();
    assert.equal((await contours())?.values?.length, 4);
    await client.button("Remove contour value 4").click();
    await type(client, "Contour value 1", "0.25");
    assert.equal((await contours())?.values?.[0], 0.25);
    await client.page.getByLabel("Lines at").selectOption("even");
    await type(client, "Contour lines from", "-1");
    assert.equal((await contours())?.range?.[0], -1);
    await client.page.getByLabel("Lines of", { exact: true }).selectOption("U:x");
    await client.settled();
    assert.deepEqual(await contours(), { array: "U:x", coloring: {} });
    assert.equal(await client.page.locator(".toast").count(), 0);
    await client.close();
  });

  test("a volume whose colors name their array can be of another one", async () => {
    const client = await opened({
      v: { type: "volume", array: "vorticity", slices: 20, color: { array: "vorticity", map: "vik" } },
    });
    await client.page.getByLabel("Array of the volume").selectOption("U:magnitude");
    await client.settled();
    assert.equal(await client.page.locator(".toast").count(), 0);
    assert.deepEqual(await legends(client), ["Colors of U:magnitude"]);
    await client.close();
  });

  test("colors of one's own stand where they are seen, also the other way round", async () => {
    const points = ["#ff0000", "#00ff00", "#0000ff"].map((color, i) => ({ at: i / 2, color }));
    const client = await opened({
      a: { ...slice, axis: "z", value: 2.4, color: { array: "vorticity", range: [-1, 1], reverse: true, points } },
    });
    await client.button("Color scale of vorticity").click();
    const value = (index: number): Promise<string> =>
      client.page.getByLabel(`Value of color ${index}`, { exact: true }).inputValue();
    assert.deepEqual([await value(1), await value(3)], ["1", "\u22121"], "red is that of the highest values");
    await client.page.getByLabel("Place of color 2").focus();
    await client.page.keyboard.press("PageUp");
    await client.settled();
    assert.equal(await value(2), "0.2", "up is towards the high values");
    await type(client, "Value of color 2", "-0.5");
    assert.equal(await client.page.getByLabel("Place of color 2").getAttribute("aria-valuenow"), "25");
    assert.deepEqual(await layers(client), {
      a: {
        ...slice,
        axis: "z",
        value: 2.4,
        color: {
          array: "vorticity",
          range: [-1, 1],
          reverse: true,
          points: points.map((point, i) => (i === 1 ? { ...point, at: 0.75 } : point)),
        },
      },
    });
    await client.close();
  });

  test("the boundary in two layers, each of which can be changed and taken away", async () => {
    const client = await opened({
      one: { type: "surface", groups: [] },
      two: { type: "surface", opacity: 0.5, color: { array: "vorticity" }, visible: false },
    });
    const before = await client.picture();
    await client.button("Show boundary 2").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.01);
    await client.button("Remove boundary 2").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.001);
    await client.button("Add another layer of the boundary").click();
    await client.settled();
    assert.equal(Object.keys(await layers(client)).length, 2);
    await client.close();
  });

  test("the outline in another color, and fewer points", async () => {
    const client = await opened({ outline: { type: "outline" }, points: { type: "points" } });
    const before = await client.picture();
    await client.page.getByLabel("Color of the outline").fill("#ff0000");
    await client.settled();
    const red = await client.picture();
    const isRed = ([r, g, b]: Color): boolean => r > 150 && g < 60 && b < 60;
    assert.equal(share(before, isRed), 0);
    assert.ok(share(red, isRed) > 0.0005);
    await type(client, "Number of points at most", "100");
    const fewer = await client.picture();
    // The color of the background depends only on the row.
    const drawn = (picture: Picture): number =>
      share(picture, (color, _x, y) => distance(color, picture.at(1, y)) > 12);
    assert.ok(drawn(fewer) < 0.9 * drawn(red), `${drawn(fewer)} of the picture instead of ${drawn(red)}`);
    assert.ok(share(fewer, isRed) >= share(red, isRed), "the outline stays");
    await client.close();
  });

  test("a picture of a size that is typed, and one of twice the view's", async () => {
    const client = await opened({ outline: { type: "outline" } });
    const saved = async (): Promise<[number, number]> => {
      const [file] = await Promise.all([client.page.waitForEvent("download"), client.button("Save", true).click()]);
      const { width, height } = decodePng(readFileSync(await file.path()));
      return [width, height];
    };
    await client.button("Pictures of other sizes").click();
    await client.page.getByLabel("Width of the picture in pixels").fill("300");
    await client.page.getByLabel("Height of the picture in pixels").fill("200");
    await client.page.keyboard.press("Enter");
    assert.deepEqual(await saved(), [300, 200]);
    await client.button("Pictures of other sizes").click();
    await client.button("2 times as large as the view").click();
    const box = await client.canvas.boundingBox();
    assert.deepEqual(await saved(), [2 * (box?.width ?? 0), 2 * (box?.height ?? 0)]);
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
