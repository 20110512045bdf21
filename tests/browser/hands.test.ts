// Tests all ways to change the scene: touch, keyboard, typing, and the controls of the panels.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import type { CDPSession } from "./chromium.ts";
import { changedLayer, type Client } from "./page.ts";
import { difference, distance, find } from "./png.ts";
import { skip, Stage } from "./stage.ts";

type Point = [number, number];
interface Camera {
  position: Point3;
  target: Point3;
}
type Point3 = [number, number, number];

const away = ({ position, target }: Camera): number =>
  Math.hypot(position[0] - target[0], position[1] - target[1], position[2] - target[2]);

describe("hands", { skip }, () => {
  const stage = new Stage({ touch: true });
  let client: Client;
  before(async () => {
    client = await stage.same();
  });
  const cameras = (): Camera[] =>
    client.patches.flatMap(({ patch }) => ("camera" in patch ? [patch.camera as Camera] : []));
  const gestures = (): number => new Set(client.patches.map(({ gesture }) => gesture)).size;

  async function fingers(session: CDPSession, path: (at: number) => Point[], steps = 6): Promise<void> {
    const points = (at: number): { x: number; y: number; id: number }[] => path(at).map(([x, y], id) => ({ x, y, id }));
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: points(0) });
    for (let i = 1; i <= steps; i += 1) {
      await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: points(i / steps) });
      await client.page.waitForTimeout(30); // one animation frame, so that moves are not merged
    }
    await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  test("two fingers that part come closer, as one step", async () => {
    const before = await client.picture();
    const session = await client.page.context().newCDPSession(client.page);
    client.patches.length = 0;
    await fingers(session, (at) => [
      [450 - 150 * at, 350],
      [500 + 150 * at, 350],
    ]);
    await client.settled();
    const [first, last] = [cameras()[0], cameras().at(-1)];
    assert.ok(first !== undefined && last !== undefined);
    assert.ok(away(last) < away(first) / 2, `from ${away(first)} to ${away(last)}`);
    assert.equal(gestures(), 1);
    const closer = await client.picture();
    assert.ok(difference(before, closer) > 0.05);
    assert.equal(await client.page.evaluate(() => window.visualViewport?.scale), 1); // the page itself is not zoomed
    await client.button("Undo").click();
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("wheel, keys and fingers stop at the target and far away, without a word", async () => {
    const session = await client.page.context().newCDPSession(client.page);
    const box = await client.canvas.boundingBox();
    await client.canvas.focus();
    await client.page.mouse.move((box?.x ?? 0) + 480, (box?.y ?? 0) + 300);
    const turned = async (delta: number): Promise<number> => {
      for (let i = 0; i < 40; i += 1) await client.page.mouse.wheel(0, delta);
      await client.settled();
      return away(cameras().at(-1) ?? { position: [0, 0, 0], target: [0, 0, 0] });
    };
    const staysAt = async (distance: number, key: string, apart: number): Promise<void> => {
      client.patches.length = 0;
      await client.page.keyboard.press(key);
      await client.settled();
      assert.deepEqual(client.patches, [], "already at the stop");
      await fingers(session, (at) => [
        [480 - 100 - apart * at, 300],
        [480 + 100 + apart * at, 300],
      ]);
      await client.settled();
      for (const camera of cameras()) assert.ok(Math.abs(away(camera) / distance - 1) < 1e-3, `${away(camera)}`);
    };
    client.patches.length = 0;
    const nearest = await turned(-1000);
    assert.ok(nearest > 0, "the eye is not where it looks");
    await staysAt(nearest, "+", 80);
    const furthest = await turned(1000);
    assert.ok(Math.abs(furthest / nearest / 1e10 - 1) < 0.01, `from ${nearest} to ${furthest}`);
    await staysAt(furthest, "-", -80);
    client.patches.length = 0;
    await client.page.keyboard.press("+");
    await client.settled();
    assert.equal(cameras().length, 1, "there is a way back");
    assert.equal(await client.page.locator(".toast").count(), 0);
    assert.deepEqual(client.problems, []);
    await client.page.keyboard.press("r");
    await client.settled();
  });

  test("one finger turns, a tap reads the values", async () => {
    const before = await client.picture();
    const session = await client.page.context().newCDPSession(client.page);
    client.patches.length = 0;
    await fingers(session, (at) => [[400 + 120 * at, 350]]);
    await client.settled();
    const [first, last] = [cameras()[0], cameras().at(-1)];
    assert.ok(first !== undefined && last !== undefined);
    assert.ok(Math.abs(away(first) / away(last) - 1) < 1e-6, "the distance stays");
    assert.ok(difference(before, await client.picture()) > 0.02);
    await client.button("Undo").click();
    await client.settled();
    const picture = await client.picture();
    const [x, y] = find(picture, (color, px, py) => {
      const inside = px > picture.width * 0.4 && py > picture.height * 0.4;
      return inside && distance(color, picture.at(1, py)) > 60;
    });
    const box = await client.canvas.boundingBox();
    await client.page.touchscreen.tap((box?.x ?? 0) + x + 2, (box?.y ?? 0) + y + 2);
    await client.page.getByLabel("Values at the clicked point").waitFor();
    await client.button("Close the values").click();
  });

  test("several iso-values: one more, moved on its own, taken away", async () => {
    const opening = await client.value();
    await client.dragIso(0.85); // a high value, so that the next iso-surface encloses this one and is visible
    await client.settled();
    const before = await client.picture();
    const value = await client.value();
    const handles = client.page.locator(".histogram-track").first().getByRole("slider");
    await client.button("Add a value").first().click();
    await client.settled();
    assert.equal(await handles.count(), 2);
    const two = await client.picture();
    assert.ok(difference(before, two) > 0.005, "a second surface is seen");
    const second = Number(await handles.nth(1).getAttribute("aria-valuenow"));
    await handles.nth(1).focus();
    await client.page.keyboard.press("PageDown");
    await client.settled();
    assert.equal(Number(await handles.nth(0).getAttribute("aria-valuenow")), value);
    assert.ok(Number(await handles.nth(1).getAttribute("aria-valuenow")) < second);
    assert.ok(difference(two, await client.picture()) > 0.001);
    await client.keep("two-values");
    await client.button("Remove value 2").click();
    await client.settled();
    assert.equal(await handles.count(), 1);
    assert.ok(difference(before, await client.picture()) < 0.005);
    for (let undone = 0; undone < 4; undone += 1) {
      await client.button("Undo").click();
      await client.settled();
    }
    assert.equal(await client.value(), opening);
  });

  test("patches come and go one by one", async (context) => {
    const section = client.page.locator(".section", { hasText: "Boundary" }).locator(".patches");
    const names = await section.locator(".check span").allTextContents();
    const boxes = section.getByRole("checkbox");
    const patches = await boxes.count();
    if (patches < 3) {
      context.skip(`no dataset with patches: ${names.join()}`);
      return;
    }
    const on = async (): Promise<boolean[]> =>
      Promise.all(Array.from({ length: patches }, (_, i) => boxes.nth(i).isChecked()));
    const state = await on();
    const start = await client.picture();
    const free = state.indexOf(false, 1);
    await boxes.nth(free).check();
    await client.settled();
    const more = await client.picture();
    assert.ok(difference(start, more) > 0.01, `${names[free] ?? ""} is seen`);
    assert.deepEqual(await on(), state.with(free, true));
    await boxes.nth(free).uncheck();
    await client.settled();
    assert.ok(difference(start, await client.picture()) < 0.005);
    await boxes.nth(0).check(); // box 0 stands for the whole boundary
    await client.settled();
    assert.deepEqual(
      await on(),
      state.map((_, i) => i === 0),
    );
    assert.ok(difference(start, await client.picture()) > 0.05);
    await client.button("Undo").click();
    await client.settled();
    assert.deepEqual(await on(), state);
  });

  test("the range of the colors: held over time, symmetric, the data's again", async () => {
    const legend = client.page.locator(".legend").first();
    const ends = async (): Promise<string[]> => [
      await legend.getByLabel(/^Lowest/).inputValue(),
      await legend.getByLabel(/^Highest/).inputValue(),
    ];
    const range = (): unknown =>
      Object.values((client.patches.at(-1)?.patch.layers ?? {}) as Record<string, { color: { range: unknown } }>)[0]
        ?.color.range;
    const own = await ends();
    await legend.getByLabel(/^Lowest/).fill("-0.5");
    await legend.getByLabel(/^Lowest/).press("Enter");
    await client.settled();
    await legend.getByRole("button", { name: /^Range symmetric/ }).click();
    await client.settled();
    const [low, high] = range() as [number, number];
    assert.ok(high > 0 && low === -high, `${low} to ${high}`);
    await legend.getByRole("button", { name: /^Range of the data/ }).click();
    await client.settled();
    assert.deepEqual(await ends(), own);
    const hold = legend.getByRole("button", { name: /^The same range/ });
    if ((await hold.count()) > 0) {
      await hold.click();
      await client.settled();
      assert.equal((range() as number[]).length, 2);
      await client.button("Undo").click();
      await client.settled();
    }
    assert.deepEqual(await ends(), own);
  });

  test("a logarithmic slider spreads what spans decades", async () => {
    const track = client.page.locator(".histogram-track").first();
    const value = await client.value();
    const array = client.page.getByLabel("Array of the iso-surface").first();
    const old = await array.inputValue();
    const names = await array.locator("option").allTextContents();
    await array.selectOption(names.find((name) => name.endsWith(":magnitude") || name === "speed") ?? old);
    await client.settled();
    const button = client.button("log axis").first();
    await button.click();
    const top = Number(await client.isoValue.getAttribute("aria-valuemax"));
    const start = Math.max(Number(await client.isoValue.getAttribute("aria-valuemin")), top / 1e6);
    await client.dragIso(0.5);
    await client.settled();
    const middle = await client.value();
    const expected = Math.sqrt(start * top);
    assert.ok(middle > expected / 1.2 && middle < expected * 1.2, `${middle} is not about ${expected}`);
    const [handle, box] = [await client.isoValue.boundingBox(), await track.boundingBox()];
    const at = ((handle?.x ?? 0) + (handle?.width ?? 0) / 2 - (box?.x ?? 0)) / (box?.width ?? 1);
    assert.ok(Math.abs(at - 0.5) < 0.03, `the handle stands at ${at}`);
    await client.keep("log-axis");
    await button.click();
    await client.button("Undo").click();
    await client.button("Undo").click();
    await client.settled();
    assert.deepEqual([await array.inputValue(), await client.value()], [old, value]);
  });

  test("typed rubbish is said and changes nothing; a value outside the data says so", async () => {
    const value = await client.value();
    const before = await client.picture();
    const field = client.page.getByLabel("Iso-value", { exact: true });
    for (const rubbish of ["abc", "1e400", "1 2"]) {
      await field.fill(rubbish);
      assert.equal(await field.getAttribute("aria-invalid"), "true");
      await field.press("Enter");
      await client.toast(`"${rubbish}" is not a number`).waitFor();
      assert.equal(await client.value(), value);
    }
    for (const far of ["1e30", "-1e30", "1e300"]) {
      await field.fill(far);
      await field.press("Enter");
      await client.settled();
      await client.page.getByText("No surface: the data goes from").waitFor();
    }
    await client.keep("rubbish");
    await field.fill(String(value));
    await field.press("Enter");
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("the tab key reaches every control, and each shows that it has the focus", async () => {
    await client.page.waitForFunction(() => document.querySelector(".toast") === null); // its buttons would vanish
    await client.page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    const reachable = await client.page.evaluate(() => {
      const controls = [...document.querySelectorAll("button, select, input, [tabindex='0']")];
      const open = controls.filter((e) => !e.matches(":disabled") && (e as HTMLElement).offsetParent !== null);
      open.forEach((e, i) => e.setAttribute("data-nth", String(i)));
      return open.map((e) => e.outerHTML.slice(0, 120));
    });
    const seen = new Set<string>();
    const dim: string[] = [];
    for (let i = 0; i < reachable.length + 5; i += 1) {
      await client.page.keyboard.press("Tab");
      const [nth, shown, html] = await client.page.evaluate(() => {
        const e = document.activeElement;
        if (e === null || e === document.body) return ["", true, ""] as const;
        const style = getComputedStyle(e);
        const mark = getComputedStyle(e, "::after").boxShadow;
        const outlined = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) > 0;
        return [e.getAttribute("data-nth") ?? "", outlined || mark !== "none", e.outerHTML.slice(0, 120)] as const;
      });
      if (nth !== "") seen.add(nth);
      if (!shown) dim.push(html);
    }
    assert.deepEqual(
      reachable.filter((_, i) => !seen.has(String(i))),
      [],
    );
    assert.deepEqual(dim, []);
  });

  test("without a mouse: a slice, a surface less and more, a turn, and all of it undone", async () => {
    const before = await client.picture();
    const keys = client.page.keyboard;
    client.patches.length = 0;
    await client.button("Add a slice across y").focus();
    await keys.press("Space");
    await keys.press("PageUp"); // the new slice's slider has the focus
    await client.settled();
    const sliced = await client.picture();
    assert.ok(difference(before, sliced) > 0.01);
    const [added, moved] = [client.patches[0], client.patches.at(-1)].map(changedLayer);
    assert.deepEqual([added?.type, added?.axis, Object.keys(moved ?? {})], ["slice", "y", ["value"]]);
    assert.ok(Number(moved?.value) > Number(added?.value), JSON.stringify([added, moved]));
    await client.button("Hide this iso-surface").first().focus();
    await keys.press("Enter");
    await client.settled();
    assert.deepEqual(changedLayer(client.patches.at(-1)), { visible: false });
    assert.ok(difference(sliced, await client.picture()) > 0.005);
    await client.canvas.focus();
    client.patches.length = 0;
    for (const key of ["ArrowLeft", "ArrowLeft", "ArrowUp", "+"]) await keys.press(key);
    await client.patched(2); // the page asks the server for the center of the turn before it sends both
    await client.settled();
    assert.deepEqual(Object.keys(client.patches.at(-1)?.patch ?? {}), ["camera"]);
    assert.ok(difference(sliced, await client.picture()) > 0.02);
    // Undoes the zoom, the rotation, the hidden surface, the moved slice, and the added slice.
    for (let i = 0; i < 5; i += 1) await keys.press("Control+z");
    await client.settled();
    assert.ok(difference(before, await client.picture()) < 0.005);
  });

  test("the readout: what a change cost, and rest", async () => {
    await client.dragIso(0.4);
    await client.settled();
    const shown = (name: string): Promise<string | null> => client.page.locator(`[data-readout=${name}]`).textContent();
    assert.match((await shown("latency")) ?? "", /^latency \d+(\.\d)? ms$/);
    assert.match((await shown("triangles")) ?? "", /^[1-9][\d\u202f]* triangles$/);
    assert.equal(await shown("stream"), "image, still");
    await client.page.getByText("idle", { exact: true }).waitFor();
    await client.button("Undo").click();
    await client.settled();
  });

  test("moving pictures as JPEG, which follow the hand as the others do; the still is the same", async () => {
    const kindsSeen = async (): Promise<string[]> =>
      client.page.evaluate(() => (globalThis as { kinds?: string[] }).kinds ?? []);
    const before = await client.picture();
    const kinds = `globalThis.kinds = [];
      const asked = globalThis.createImageBitmap;
      globalThis.createImageBitmap = (blob) => (globalThis.kinds.push(blob.type), asked(blob));`;
    await client.page.evaluate(kinds);
    await client.page.getByLabel("Stream").selectOption("jpeg");
    await client.dragCanvas([0.5, 0.5], [0.6, 0.5]);
    await client.settled();
    const seen = await kindsSeen();
    assert.equal(seen.at(-1), "image/png");
    assert.ok(seen.includes("image/jpeg"), seen.join());
    await client.button("Undo").click();
    await client.settled();
    assert.equal(difference(before, await client.picture()), 0);
    await client.page.getByLabel("Stream").selectOption("image");
    await client.page.evaluate("globalThis.kinds = []");
    await client.dragCanvas([0.5, 0.5], [0.6, 0.5]);
    await client.settled();
    assert.ok(!(await kindsSeen()).includes("image/jpeg"));
    await client.button("Undo").click();
    await client.settled();
  });

  test("the automatic stream: pictures from a server as fast as this machine, polygons for a graphics card", async () => {
    await client.page.getByLabel("Stream").selectOption("auto");
    await client.dragCanvas([0.5, 0.5], [0.55, 0.5]);
    await client.settled("image");
    await client.button("Undo").click();
    await client.page.getByLabel("Stream").selectOption("image");
    const card = `const asked = WebGL2RenderingContext.prototype.getParameter;
      WebGL2RenderingContext.prototype.getParameter = function (name) {
        const answer = asked.call(this, name);
        return typeof answer === "string" && /swiftshader/i.test(answer) ? "A graphics card" : answer;
      };`;
    const other = await stage.fresh({ before: `${card} localStorage.setItem("ciel.stream", "image")` });
    const image = await other.picture();
    await other.page.getByLabel("Stream").selectOption("geometry"); // the transfer of polygons measures the line rate
    await other.settled("geometry");
    await other.page.getByLabel("Stream").selectOption("auto");
    await other.settled("geometry");
    assert.ok(difference(image, await other.picture()) < 0.08);
    assert.deepEqual(other.problems, []);
    await other.close();
  });

  test("nothing went wrong on the way", () => assert.deepEqual(client.problems, []));
});
