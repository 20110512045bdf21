// Tests that in small windows all controls of the toolbar and time bar can be reached, and that the time slider is wide
// enough.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import type { Client } from "./page.ts";
import { skip, Stage } from "./stage.ts";

const SIZES = [
  [375, 700],
  [360, 640],
  [400, 300],
  [700, 500],
] as const;
const HANDLE = 72; // smallest slider width in pixels

/** Names of the controls in toolbar and time bar whose center a pointer cannot hit. */
const outOfReach = (client: Client): Promise<string[]> =>
  client.page.locator(".toolbar button, .toolbar select, .time-bar button, .time-bar select").evaluateAll((controls) =>
    controls.flatMap((control) => {
      const { left, top, width, height } = control.getBoundingClientRect();
      const hit = document.elementFromPoint(left + width / 2, top + height / 2);
      const isHit = width >= 24 && control.contains(hit) && left >= 0 && left + width <= innerWidth;
      return isHit ? [] : [control.getAttribute("aria-label") ?? control.tagName];
    }),
  );

describe("small windows", { skip }, () => {
  const stage = new Stage();
  for (const [width, height] of SIZES) {
    test(`${width} x ${height}: every control of the rows, and what they open`, async () => {
      const client = await stage.fresh({ width, height });
      await client.keep(`narrow-${width}`);
      assert.deepEqual(await outOfReach(client), []);
      const dataset = await client.page.getByLabel("Dataset", { exact: true }).boundingBox();
      assert.ok((dataset?.width ?? 0) >= 100, `the dataset's name has ${dataset?.width ?? 0} pixels`);
      for (const menu of ["Pictures of other sizes", "Export a surface"]) {
        await client.button(menu).click();
        const box = await client.page.locator(".menu-body").boundingBox();
        assert.ok(box !== null && box.x >= 0 && box.x + box.width <= width, `${menu} reaches out: ${box?.x ?? NaN}`);
        await client.page.keyboard.press("Escape");
      }
      await client.button("Side panel").click();
      assert.deepEqual(await outOfReach(client), []);
      const slider = client.page.getByLabel("Time step", { exact: true });
      if ((await slider.count()) > 0) {
        const track = await slider.boundingBox();
        assert.ok(track !== null && track.width >= HANDLE, `the slider has ${track?.width ?? 0} pixels`);
        await client.page.mouse.click(track.x + track.width - 9, track.y + track.height / 2);
        assert.equal(await slider.inputValue(), await slider.getAttribute("max"));
      }
      assert.deepEqual(client.problems, []);
      await client.close();
    });
  }
});
