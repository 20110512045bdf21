// Tests typed numbers: ends of ranges, groups of thousands, rejected texts.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const range = [0.19, 4.98];
const looks = { color: { array: "U:magnitude", range }, contours: { array: "U:magnitude", range } };
const scene = {
  dataset: nameOf(data[0] ?? ""),
  layers: {
    s: { type: "slice", axis: "z", value: 2.4, ...looks },
    y: { type: "slice", axis: "y", value: 3, visible: false, ...looks },
    plane: { type: "slice", origin: [5, 0, 2], normal: [1, 0, 0], ...looks },
    volume: { type: "volume", array: "tracer", slices: 20, color: { range: [0, 1] } },
  },
};

describe("typing", { skip }, () => {
  const stage = new Stage();
  let client: Client;
  before(async () => {
    client = await stage.fresh({ width: 1280, height: 900 }, fragmentOf(scene));
    await client.button("Color scale of U:magnitude").click();
  });

  const field = (name: string): ReturnType<Client["page"]["getByLabel"]> =>
    client.page.getByRole("textbox", { name, exact: true });
  const type = async (name: string, text: string): Promise<void> => {
    await field(name).fill(text);
    await field(name).press("Tab");
  };
  const values = (...names: string[]): Promise<string[]> => Promise.all(names.map((name) => field(name).inputValue()));
  const check = (name: string): ReturnType<Client["page"]["getByLabel"]> =>
    client.page.getByLabel(name, { exact: true });

  for (const [what, from, to] of [
    ["colors", "Range from", "Range to"],
    ["contour lines", "Contour lines from", "Contour lines to"],
    ["the legend", "Lowest value of the U:magnitude colors", "Highest value of the U:magnitude colors"],
  ] as const)
    test(`an end of the range of ${what} pushes the other before it`, async () => {
      await type(to, "4.98");
      await type(from, "0.19");
      await type(from, "5");
      assert.deepEqual(await values(from, to), ["5", "5"]);
      await type(to, "10");
      assert.deepEqual(await values(from, to), ["5", "10"]);
      await type(to, "2");
      assert.deepEqual(await values(from, to), ["2", "2"]);
      await type(to, "4.98");
      await type(from, "0.19");
      await client.settled();
    });

  test("a logarithm that is switched on and off leaves Symmetric and the range as they were", async () => {
    await type("Range from", "-3");
    await check("Symmetric").check();
    const wide = await values("Range from", "Range to");
    await check("Logarithmic").check();
    assert.notDeepEqual(await values("Range from", "Range to"), wide);
    await check("Logarithmic").uncheck();
    assert.ok(await check("Symmetric").isChecked());
    assert.deepEqual(await values("Range from", "Range to"), wide);
    await check("Symmetric").uncheck();
    await type("Range from", "0.19");
  });

  test("a comma that may part thousands is asked about, a group of three is not", async () => {
    await type("Position on z", "1,500");
    await client.toast('"1,500" can be read in two ways; write 1500 or 1.500; Position on z stays 2.4').waitFor();
    assert.equal(await field("Position on z").inputValue(), "2.4");
    await type("Position on z", "1,5");
    assert.equal(await field("Position on z").inputValue(), "1.5");
    await type("Position on z", "1\u202f500");
    assert.equal(await field("Position on z").inputValue(), "1500");
    await type("Position on z", "2.4");
  });

  test("an empty field is asked for a number by Enter, and is as it was when it is left", async () => {
    await type("Position on z", "");
    assert.equal(await field("Position on z").inputValue(), "2.4");
    assert.equal(await client.toast("The number is missing").count(), 0);
    await field("Position on z").fill("");
    await field("Position on z").press("Enter");
    await client.toast("The number is missing; Position on z stays 2.4").waitFor();
    assert.equal(await field("Position on z").inputValue(), "2.4");
  });

  test("a hidden slice is moved by typing and stays hidden, as other layers do", async () => {
    await type("Position on y", "2");
    const card = client.page.getByRole("article", { name: "Slice at y = 2" });
    await card.getByRole("button", { name: "Show this slice" }).waitFor();
    await client.settled();
  });

  test("a normal without a direction is refused with a sentence", async () => {
    await type("Normal x", "0");
    await client.toast(/A normal of 0, 0, 0 has no direction/).waitFor();
    assert.equal(await field("Normal x").inputValue(), "1");
  });

  test("a point of an opacity curve is typed, and stays between its neighbours", async () => {
    await client.button("Add an opacity point").click();
    await client.page.getByRole("slider", { name: "Opacity point 2" }).focus();
    await type("Value of opacity point 2", "0.25");
    await type("Opacity of opacity point 2 in percent", "60");
    const slider = client.page.getByRole("slider", { name: "Opacity point 2" });
    assert.equal(await slider.getAttribute("aria-valuetext"), "60 % at 0.25");
    await client.keep("typing-opacity");
    await type("Value of opacity point 2", "-4");
    assert.deepEqual(await values("Value of opacity point 2"), ["0"]);
    await type("Opacity of opacity point 2 in percent", "160");
    assert.deepEqual(await values("Opacity of opacity point 2 in percent"), ["100"]);
  });

  test("a number outside its limits becomes the nearest, which is said", async () => {
    await type("Number of slices", "1e30");
    await client.toast("Number of slices must be from 0 to 1000; 1e30 was changed to 1000").waitFor();
    assert.equal(await field("Number of slices").inputValue(), "1000");
    await type("Number of slices", "20");
  });

  test("a point of one's own colors stays between its neighbours, which is said", async () => {
    await check("Colors of my own").first().check();
    const before = await values("Value of color 1", "Value of color 2");
    await type("Value of color 1", String(Number(before[1]) + 1));
    await client.toast(/^Value of color 1 must be from .* was changed to/).waitFor();
    assert.deepEqual(await values("Value of color 1"), [before[1]]);
    await check("Colors of my own").first().uncheck();
  });

  test("a logarithm over values below zero says what becomes of them", async () => {
    const hint = client.page.getByText(
      /^U:x goes down to \u2212\d.*: values up to zero have the color of the lower end/,
    );
    const section = client.page.locator(".section").filter({ has: client.button("Slices", true) });
    await section.getByLabel("Color by").selectOption("U:x");
    await check("Logarithmic").first().check();
    await hint.waitFor();
    await check("Logarithmic").first().uncheck();
    assert.equal(await hint.count(), 0);
  });

  test("nothing went wrong on the way", () => assert.deepEqual(client.problems, []));
});
