// Tests slices: several across one axis and free ones, each with its own plane, colors and lines.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import type { Locator } from "./chromium.ts";
import { fragmentOf, sceneOf } from "./link.ts";
import type { Client } from "./page.ts";
import { difference } from "./png.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

interface Slice {
  order?: number;
  axis?: string;
  value?: number;
  normal?: number[];
  visible?: boolean;
  opacity?: number;
  color?: { array?: string; map?: string };
  contours?: { array: string; count?: number };
  edges?: { visible?: boolean };
}
type Slices = Record<string, Slice>;

const camera = { position: [20, -25, 15], target: [5, 0, 2], up: [0, 0, 1] } as const;
const at = (axis: string, value: number, looks: object = {}): object => ({
  type: "slice",
  axis,
  value,
  color: { array: "tracer" },
  ...looks,
});

describe("slices", { skip }, () => {
  const stage = new Stage();
  const opened = (layers: object = {}): Promise<Client> =>
    stage.fresh({ width: 1280, height: 900 }, fragmentOf({ dataset: nameOf(data[0] ?? ""), camera, layers }));
  const cards = (client: Client): Locator => client.page.getByRole("article", { name: /^(Slice at|Plane through)/ });
  const names = (client: Client): Promise<string[]> =>
    cards(client).evaluateAll((all) => all.map((card) => card.getAttribute("aria-label") ?? ""));
  const card = (client: Client, name: string): Locator => client.page.getByRole("article", { name, exact: true });
  const unfold = (of: Locator): Promise<void> => of.getByRole("button", { name: /^Looks/ }).click();
  const rpc = async (client: Client, method: string, params: object = {}): Promise<unknown> => {
    const session = await client.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method, params: { session, ...params } });
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch(new URL("rpc", stage.server.address), { method: "POST", headers, body });
    return ((await answer.json()) as { result: unknown }).result;
  };
  /** Slices of the server's scene. */
  const slices = async (client: Client): Promise<Slices> => {
    await client.settled();
    const { scene } = (await rpc(client, "scene.get")) as { scene: { layers?: Slices } };
    return scene.layers ?? {};
  };
  const undo = async (client: Client): Promise<void> => {
    await client.button("Undo").click();
    await client.settled();
  };
  const done = async (client: Client): Promise<void> => {
    assert.deepEqual(client.problems, []);
    assert.equal(await client.page.locator(".toast").count(), 0);
    await client.close();
  };

  test("the first takes one click and is swept by keys at once; the next lies elsewhere and shows another array", async () => {
    const client = await opened();
    await client.button("Add a slice across x").click();
    await client.settled();
    const before = await client.picture();
    const [middle] = Object.values(await slices(client)).map(({ value }) => Number(value));
    client.patches.length = 0;
    for (let i = 0; i < 3; i += 1) await client.page.keyboard.press("PageUp");
    await client.settled();
    const [swept] = Object.values(await slices(client)).map(({ value }) => Number(value));
    assert.ok(Number(swept) > Number(middle), `${swept} after ${middle}`);
    assert.ok(difference(before, await client.picture()) > 0.005);
    const first = cards(client).first();
    await first.getByLabel("Map").selectOption("magma");
    await first.getByLabel("Contour lines").check();
    await client.button("Add a slice across x").click();
    await client.button("Add a slice across y").click();
    await client.button("Add a free slice plane").click();
    const all = Object.values(await slices(client)).sort((a, b) => (a.order ?? 0) - (b.order ?? 0));
    assert.deepEqual(
      all.map(({ axis }) => axis),
      ["x", "x", "y", undefined],
    );
    assert.notEqual(all[0]?.value, all[1]?.value);
    const arrays = all.map(({ color }) => color?.array);
    assert.equal(new Set(arrays.slice(0, 3)).size, 3, `three slices show ${arrays.join()}`);
    assert.equal(new Set(all.map(({ contours }) => JSON.stringify(contours))).size, 1, "lines as on the first");
    assert.deepEqual([arrays[3], all[3]?.color?.map], [arrays[0], "magma"], "equal arrays share one scale");
    const shown = await client.page
      .locator(".legend")
      .evaluateAll((all) => all.map((one) => one.getAttribute("title")));
    assert.equal(new Set(shown).size, shown.length, `one legend for each array: ${shown.join()}`);
    assert.equal(await client.page.getByRole("button", { name: /^Looks/, expanded: true }).count(), 1);
    await client.keep("slices");
    await done(client);
  });

  test("two across one axis have colors, contour lines, edges and opacity each for itself", async () => {
    const client = await opened({ a: at("x", 2), b: at("x", 8) });
    const plain = await client.picture();
    const a = card(client, "Slice at x = 2");
    const b = card(client, "Slice at x = 8");
    await unfold(b);
    await b.getByLabel("Color by").selectOption("U:magnitude");
    await b.getByLabel("Map").selectOption("magma");
    await b.getByLabel("Contour lines").check();
    await b.getByLabel("Lines of", { exact: true }).selectOption("vorticity");
    await b.getByLabel("Number of contour lines").fill("4");
    await client.page.keyboard.press("Enter");
    await b.getByLabel("Cell edges").check();
    await b.getByLabel("Opacity").fill("50");
    const first = await slices(client);
    assert.deepEqual(first.a, at("x", 2), "the other one is as it was");
    assert.deepEqual(first.b?.color, { array: "U:magnitude", map: "magma" });
    assert.deepEqual([first.b.contours?.array, first.b.contours?.count], ["vorticity", 4]);
    assert.deepEqual([first.b.edges?.visible, first.b.opacity], [true, 0.5]);
    assert.equal(await client.page.getByLabel("Colors of tracer").count(), 1);
    assert.equal(await client.page.getByLabel("Colors of U:magnitude").count(), 1);
    assert.ok(difference(plain, await client.picture()) > 0.01);
    await a.getByLabel("Contour lines").check();
    const second = await slices(client);
    assert.equal(second.a?.contours?.array, "tracer");
    assert.deepEqual(second.b, first.b);
    await client.keep("slices-each");
    await unfold(b);
    await b.getByText("U:magnitude, lines of vorticity, cell edges").waitFor();
    await done(client);
  });

  test("one is hidden, one is taken away, and each comes back by one undo", async () => {
    const client = await opened({ a: at("x", 2), b: at("x", 8, { color: { array: "tracer", map: "magma" } }) });
    const both = await client.picture();
    await card(client, "Slice at x = 2").getByRole("button", { name: "Hide this slice" }).click();
    await client.settled();
    const without = await client.picture();
    assert.ok(difference(both, without) > 0.005);
    await undo(client);
    await card(client, "Slice at x = 2").getByRole("button", { name: "Remove this slice" }).click();
    await client.settled();
    assert.deepEqual(await names(client), ["Slice at x = 8"]);
    assert.ok(difference(without, await client.picture()) < 0.001);
    await undo(client);
    assert.deepEqual(await names(client), ["Slice at x = 2", "Slice at x = 8"]);
    assert.ok(difference(both, await client.picture()) < 0.001);
    await done(client);
  });

  test("a drag of a position moves that slice alone and is one step of undo", async () => {
    const client = await opened({ a: at("z", 1), b: at("z", 3) });
    const track = await card(client, "Slice at z = 3").getByLabel("Position of the z slice").boundingBox();
    if (track === null) throw new Error("no slider");
    const y = track.y + track.height / 2;
    client.patches.length = 0;
    await client.drag([track.x + track.width * 0.63, y], [track.x + track.width * 0.9, y], 10);
    const { a, b } = await slices(client);
    assert.equal(a?.value, 1);
    assert.ok((b?.value ?? 0) > 4);
    assert.equal(new Set(client.patches.map(({ gesture }) => gesture)).size, 1);
    await undo(client);
    assert.deepEqual(await names(client), ["Slice at z = 1", "Slice at z = 3"]);
    await done(client);
  });

  test("a plane is laid across another axis, freed, and turned; each is one step of undo", async () => {
    const client = await opened({ a: at("x", 2, { opacity: 0.5 }) });
    const only = cards(client).first();
    const plane = only.getByLabel("Plane of the slice");
    const before = await client.picture();
    await plane.selectOption("z");
    await client.settled();
    assert.equal((await slices(client)).a?.axis, "z");
    assert.ok(difference(before, await client.picture()) > 0.01);
    await undo(client);
    assert.equal((await slices(client)).a?.axis, "x");
    await plane.selectOption("free");
    assert.deepEqual((await slices(client)).a?.normal, [1, 0, 0]);
    assert.ok(difference(before, await client.picture()) < 0.001, "it is where it was");
    await only.getByLabel("Normal y").fill("1");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.ok(difference(before, await client.picture()) > 0.01);
    await undo(client);
    await undo(client);
    assert.deepEqual((await slices(client)).a, at("x", 2, { opacity: 0.5 }));
    await done(client);
  });

  test("a link with several shows a card for each, and leads others to what became of them", async () => {
    const plane = { type: "slice", origin: [5, 0, 2], normal: [1, 1, 0], color: { array: "vorticity" } };
    const client = await opened({ a: at("x", 2), b: at("x", 8), c: at("y", 1, { visible: false }), d: plane });
    const wanted = ["Slice at x = 2", "Slice at x = 8", "Slice at y = 1", "Plane through (5, 0, 2), normal (1, 1, 0)"];
    assert.deepEqual(await names(client), wanted);
    for (const [name, map] of wanted.map((name, i) => [name, ["magma", "inferno", "plasma", "cividis"][i]] as const)) {
      const one = card(client, name);
      if ((await one.getByLabel("Map").count()) === 0) await unfold(one);
      await one.getByLabel("Map").selectOption(map ?? "");
    }
    await card(client, "Slice at y = 1").getByRole("button", { name: "Show this slice" }).click();
    await client.settled();
    await client.addressed();
    const picture = await client.picture();
    const { layers } = sceneOf(client.page.url()) as { layers: Slices };
    assert.deepEqual(
      ["a", "b", "c", "d"].map((id) => layers[id]?.color?.map),
      ["magma", "inferno", "plasma", "cividis"],
    );
    const other = await stage.open(client.page.url(), { width: 1280, height: 900 });
    await other.settled();
    assert.deepEqual(await names(other), wanted);
    assert.deepEqual(await slices(other), await slices(client));
    assert.ok(difference(picture, await other.picture()) < 0.001);
    await done(other);
    await done(client);
  });

  test("one that another client adds has a card too, and changes nothing of what a hand has open", async () => {
    const client = await opened({ a: at("x", 2) });
    await rpc(client, "scene.patch", { patch: { layers: { b: at("x", 8, { order: -1 }) } } });
    await card(client, "Slice at x = 8").waitFor();
    await client.settled();
    assert.ok(await card(client, "Slice at x = 2").getByLabel("Color by").isVisible());
    assert.equal(await card(client, "Slice at x = 8").getByLabel("Color by").count(), 0);
    await done(client);
  });

  test("all are made alike in one step, and their planes stay", async () => {
    const looks = { color: { array: "tracer", map: "magma" }, contours: { array: "vorticity" }, opacity: 0.5 };
    const client = await opened({ a: at("x", 2, looks), b: at("x", 8, { edges: {} }), c: at("y", 1) });
    const before = await slices(client);
    const button = card(client, "Slice at x = 2").getByRole("button", { name: "All slices like this one" });
    await button.click();
    assert.deepEqual(await slices(client), { a: at("x", 2, looks), b: at("x", 8, looks), c: at("y", 1, looks) });
    assert.ok(await button.isDisabled());
    await undo(client);
    assert.deepEqual(await slices(client), before);
    await done(client);
  });

  test("one that cannot be seen says why, folded or not", async () => {
    const client = await opened({ a: at("x", 2), b: at("x", 8, { opacity: 0 }) });
    const hint = card(client, "Slice at x = 8").getByText("The layer shows nothing.");
    await hint.waitFor();
    await unfold(card(client, "Slice at x = 8"));
    assert.equal(await hint.count(), 1);
    await done(client);
  });

  test("a free plane beside the data says so, until it is moved back", async () => {
    const plane = { type: "slice", origin: [500, 0, 2], normal: [1, 0, 0], color: { array: "tracer" } };
    const client = await opened({ a: plane, b: at("x", 2) });
    const free = cards(client).first();
    await free.getByText("No slice: the plane lies beside the data.").waitFor();
    await free.getByLabel("Origin x").fill("5");
    await client.page.keyboard.press("Enter");
    await client.settled();
    assert.equal(await client.page.getByText("No slice").count(), 0);
    await done(client);
  });
});
