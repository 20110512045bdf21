// Tests that each control of each panel makes one undo step. Changes, undoes and redoes it, and compares the server's
// scene each time.
import assert from "node:assert/strict";
import { before, describe, test } from "node:test";
import type { Locator } from "./chromium.ts";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { nameOf } from "./server.ts";
import { data, skip, Stage } from "./stage.ts";

const threshold = { array: "tracer", range: [0, 0.5] };
const by = { array: "tracer" };
/**
 * Layers are hidden, because only the scene is compared and drawing would take most of the time. The boundary stays
 * visible, because a hidden one has few controls.
 */
const hidden = { visible: false };
const layers = {
  iso: { ...hidden, type: "iso", array: "tracer", values: [0.3], color: by, edges: { width: 1 } },
  slice: { ...hidden, type: "slice", axis: "z", value: 2.4, color: by, contours: { array: "tracer", coloring: {} } },
  plane: { ...hidden, type: "slice", origin: [5, 0, 2], normal: [1, 1, 0], color: by },
  clip: { type: "clip", axis: "y", value: 3 },
  free: { type: "clip", origin: [5, 4, 2], normal: [0, 1, 1] },
  surface: { type: "surface", color: by, threshold },
  edges: { ...hidden, type: "edges", angle: 30, threshold },
  points: { ...hidden, type: "points", threshold, most: 1000 },
  volume: { ...hidden, type: "volume", array: "tracer", slices: 20 },
  outline: { type: "outline" },
};
const lighting = { ambient_occlusion: { on: true } };

/** Smallest number of controls in each panel. It reveals controls that are no longer found. */
const PANELS: readonly (readonly [string, number])[] = [
  ["Iso-surfaces", 8],
  ["Slices", 12],
  ["Volumes", 6],
  ["Boundary", 19],
  ["Lines and points", 12],
  ["Clip", 8],
  ["Camera", 8],
  ["Lighting", 8],
  ["View", 8],
];
/** Controls that do not change the scene. */
const OWN = ["Stream"];

const CONTROLS = "input[type=checkbox], select, input[type=range], input[type=color], input[type=text], [role=slider]";

const sorted = (value: unknown): unknown => {
  if (Array.isArray(value)) return value.map(sorted);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(
    Object.entries(value)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([key, member]) => [key, sorted(member)]),
  );
};

describe("undo", { skip }, () => {
  const stage = new Stage();
  let client: Client;
  let session = "";
  before(async () => {
    const scene = { dataset: nameOf(data[0] ?? ""), layers, lighting };
    client = await stage.fresh({ width: 800, height: 600 }, fragmentOf(scene));
    session = (await client.page.evaluate(() => sessionStorage.getItem("ciel.session"))) ?? "";
  });

  async function state(): Promise<{ revision: number; scene: string }> {
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "scene.get", params: { session } });
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch(new URL("rpc", stage.server.address), { method: "POST", headers, body });
    const { result } = (await answer.json()) as { result: { revision: number; scene: unknown } };
    return { revision: result.revision, scene: JSON.stringify(sorted(result.scene)) };
  }

  /** Returns the server's scene once the page has it, too. */
  async function agreed(): Promise<{ revision: number; scene: string }> {
    const deadline = Date.now() + 10_000;
    for (;;) {
      const now = await state();
      if ((await client.wanted()) === now.revision) return now;
      if (Date.now() > deadline) throw new Error(`the page has not got revision ${now.revision}`);
      await client.page.waitForTimeout(20);
    }
  }

  /** Returns the scene after its revision has changed and settled. After 400 ms without a change, returns it unchanged. */
  async function moved(from: number): Promise<{ revision: number; scene: string }> {
    const deadline = Date.now() + 400;
    let now = await agreed();
    while (now.revision === from && Date.now() < deadline) {
      await client.page.waitForTimeout(20);
      now = await agreed();
    }
    for (let last = -1; last !== now.revision; now = await agreed()) {
      last = now.revision;
      await client.page.waitForTimeout(60);
    }
    return now;
  }

  /** Clicks the button and returns whether the scene becomes `scene`. */
  async function leadsTo(button: "Undo" | "Redo", scene: string): Promise<boolean> {
    await client.button(button).click();
    const deadline = Date.now() + 4000;
    while ((await agreed()).scene !== scene) {
      if (Date.now() > deadline) return false;
      await client.page.waitForTimeout(20);
    }
    return true;
  }

  async function use(control: Locator): Promise<void> {
    const kind = await control.evaluate((element) => `${element.tagName} ${element.getAttribute("type") ?? ""}`);
    if (kind === "INPUT checkbox") await control.click();
    else if (kind.startsWith("SELECT")) {
      const other = await control.evaluate((element) => {
        const { options, selectedIndex } = element as HTMLSelectElement;
        return options[(selectedIndex + 1) % options.length]?.value ?? "";
      });
      await control.selectOption(other);
    } else if (kind === "INPUT color") await control.fill("#123456");
    else if (kind === "INPUT text") {
      const value = await control.inputValue();
      await control.fill(value === "" || Number.isNaN(Number(value)) ? "2" : String(Number(value) * 0.9 + 0.1));
      await control.press("Enter");
    } else {
      const [now, most] = await control.evaluate((element) =>
        element instanceof HTMLInputElement
          ? [element.value, element.max]
          : [element.getAttribute("aria-valuenow"), element.getAttribute("aria-valuemax")],
      );
      await control.focus();
      await control.press(Number(now) === Number(most) ? "ArrowLeft" : "ArrowRight");
    }
  }

  for (const [panel, least] of PANELS)
    test(`of each control of ${panel}`, async () => {
      const section = client.page
        .locator(".section")
        .filter({ has: client.page.getByRole("button", { name: panel, exact: true }) });
      const head = section.getByRole("button", { name: panel, exact: true });
      if ((await head.getAttribute("aria-expanded")) === "false") await head.click();
      const count = await section.locator(CONTROLS).count();
      const wrong: string[] = [];
      let changed = 0;
      for (let i = 0; i < count; i += 1) {
        const control = section.locator(CONTROLS).nth(i);
        if (!(await control.isVisible()) || !(await control.isEnabled())) continue;
        const name = await control.evaluate(
          (element) => element.getAttribute("aria-label") ?? element.closest("label")?.textContent ?? "",
        );
        if (OWN.includes(name)) continue;
        const was = await agreed();
        await use(control);
        const then = await moved(was.revision);
        if (then.scene === was.scene) continue; // the control was at the end of its range
        changed += 1;
        if (!(await leadsTo("Undo", was.scene))) wrong.push(`${name}: undone is not what it was`);
        if (!(await leadsTo("Redo", then.scene))) wrong.push(`${name}: done again is not what it became`);
        if (!(await leadsTo("Undo", was.scene))) wrong.push(`${name}: undone once more is not what it was`);
        assert.equal(await section.locator(CONTROLS).count(), count, `${name}: the controls are those that were`);
      }
      assert.deepEqual(wrong, []);
      assert.ok(changed >= least, `${changed} controls changed the scene, of ${count}`);
      assert.deepEqual(client.problems, []);
    });
});
