// Tests the R key, the pivot of an orbit, a double click beside all geometry, and keys after a choice in a list.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { barIn } from "./bar.ts";
import { fragmentOf } from "./link.ts";
import type { Client } from "./page.ts";
import { Server } from "./server.ts";
import { skip, Stage } from "./stage.ts";

type Vec3 = [number, number, number];
interface Camera {
  position: Vec3;
  target: Vec3;
}

describe("framing", { skip }, () => {
  const stage = new Stage();
  const folder = mkdtempSync(join(tmpdir(), "ciel-framing-"));
  let server: Server;
  before(async () => {
    server = await Server.started([barIn(folder, 40)]);
  });
  after(async () => {
    await server.stop();
    rmSync(folder, { recursive: true });
  });

  const lighting = { on: false };
  const open = async (scene: object): Promise<Client> => {
    const client = await stage.open(server.address + fragmentOf({ dataset: "bar", lighting, ...scene }));
    await client.settled();
    return client;
  };
  const cameraOf = async (client: Client): Promise<Camera> => {
    const session = await client.page.evaluate(() => sessionStorage.getItem("ciel.session"));
    const body = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "scene.get", params: { session } });
    const headers = { "Content-Type": "application/json" };
    const answer = await fetch(new URL("rpc", server.address), { method: "POST", headers, body });
    return ((await answer.json()) as { result: { scene: { camera: Camera } } }).result.scene.camera;
  };
  /** Share of the picture that is brighter than the background. */
  const lit = async (client: Client): Promise<number> => {
    const picture = await client.picture();
    let count = 0;
    for (let y = 0; y < picture.height; y += 4)
      for (let x = 0; x < picture.width; x += 4) if (Math.min(...picture.at(x, y)) > 100) count += 1;
    return count / ((picture.width / 4) * (picture.height / 4));
  };
  const middleOf = async (client: Client): Promise<[number, number]> => {
    const box = await client.canvas.boundingBox();
    return [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  };
  /** Near the end of the bar at x = 40. The target is far behind the bar. */
  const besideTheEnd = {
    camera: { position: [39.5, -6, 0.5], target: [39.5, 60, 0.5], up: [0, 0, 1] },
    layers: { all: { type: "surface", groups: ["bar_39-front"] } },
  };
  const press = async (client: Client, key: string): Promise<void> => {
    client.patches.length = 0;
    await client.page.keyboard.press(key);
    await client.patched();
    await client.settled();
  };

  test("home shows what is drawn, with Shift the whole box, and so does a look along an axis", async () => {
    const far = { position: [20, -120, 30], target: [20, 0, 0], up: [0, 0, 1] };
    const end = { type: "surface", groups: ["bar_39-front", "bar_39-back", "outlet"] };
    const slice = { type: "slice", axis: "z", value: 0.5 };
    const client = await open({ camera: far, layers: { end, slice, outline: { type: "outline" } } });
    await client.canvas.focus();
    await press(client, "r");
    const { target } = await cameraOf(client);
    assert.ok(Math.hypot(target[0] - 39.5, target[1] - 0.5, target[2] - 0.5) < 0.3, `looks at ${target.join()}`);
    await client.keep("home");
    await press(client, "Shift+R");
    assert.ok(Math.abs((await cameraOf(client)).target[0] - 20) < 1, "the whole box");
    await press(client, "y");
    assert.ok(Math.abs((await cameraOf(client)).target[0] - 39.5) < 0.3);
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a turn beside a body that is not the target keeps it in the window, about what is under the cursor", async () => {
    const client = await open(besideTheEnd);
    const before = await lit(client);
    const middle = await middleOf(client);
    await client.page.mouse.move(...middle);
    await client.page.mouse.down();
    await client.page.waitForTimeout(500); // time for the server to find the pivot
    await client.page.mouse.move(middle[0] + 120, middle[1] + 40, { steps: 12 });
    await client.page.mouse.up();
    await client.settled();
    await client.keep("turned-near");
    assert.ok((await lit(client)) > 0.5 * before, "it is still seen");
    const { position } = await cameraOf(client);
    const away = Math.hypot(position[0] - 39.5, position[1], position[2] - 0.5);
    assert.ok(Math.abs(away - 6) < 0.1, `the eye is ${away} from it, as before`);
    assert.ok(Math.hypot(position[0] - 39.5, position[2] - 0.5) > 1, "and has turned");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("a turn that begins before the server has told the center keeps the body in the window too", async () => {
    const client = await open(besideTheEnd);
    const before = await lit(client);
    const middle = await middleOf(client);
    await client.drag(middle, [middle[0] + 120, middle[1] + 40], 12);
    await client.settled();
    await client.keep("turned-at-once");
    assert.ok((await lit(client)) > 0.5 * before, "it is still seen");
    await client.close();
  });

  test("beside everything it turns about the middle of what is seen", async () => {
    const client = await open(besideTheEnd);
    const box = await client.canvas.boundingBox();
    const corner: [number, number] = [(box?.x ?? 0) + 40, (box?.y ?? 0) + 40];
    await client.page.mouse.move(...corner);
    await client.page.mouse.down();
    await client.page.waitForTimeout(500);
    await client.page.mouse.move(corner[0] + 100, corner[1], { steps: 10 });
    await client.page.mouse.up();
    await client.settled();
    const { position } = await cameraOf(client);
    assert.ok(Math.abs(Math.hypot(position[0] - 39.5, position[1], position[2] - 0.5) - 6) < 0.1);
    await client.close();
  });

  test("a double click beside everything says what it does", async () => {
    const client = await open({ layers: { all: { type: "surface" } } });
    const before = await cameraOf(client);
    await client.canvas.dblclick({ position: { x: 20, y: 300 } });
    await client.toast(/Nothing is drawn at the cursor. Double-click a surface to center the view on it/).waitFor();
    assert.deepEqual(await cameraOf(client), before);
    await client.close();
  });

  test("keys work after a choice in a list, and after a tick", async () => {
    const client = await open({ layers: { all: { type: "surface" } } });
    const list = client.page.getByLabel("Background", { exact: true });
    await list.scrollIntoViewIfNeeded();
    await list.dispatchEvent("pointerdown");
    await list.focus();
    await list.selectOption("light");
    await press(client, "x");
    assert.ok((await cameraOf(client)).position[0] > 40, "looks from +x");
    await client.page.getByRole("checkbox", { name: "Axes of the box" }).check();
    await client.settled();
    await press(client, "Shift+Y");
    assert.ok((await cameraOf(client)).position[1] < -1, "looks from -y");
    await list.focus();
    await client.page.keyboard.press("ArrowDown"); // after a choice by keys the list keeps the focus
    assert.ok(await list.evaluate((element) => element === document.activeElement));
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
