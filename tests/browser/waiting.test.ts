// Tests the page's messages while it waits for a still or for the server.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { beginHolding, heldStill, letGo } from "./held_still.ts";
import { skip, Stage } from "./stage.ts";

describe("waiting", { skip }, () => {
  const stage = new Stage();

  test("a full picture that is long in coming is said to be on its way, until it is there", async () => {
    const client = await stage.fresh({ before: heldStill });
    const notice = client.page.locator("[data-readout=drawing]");
    assert.equal(await notice.textContent(), "");
    assert.equal(await notice.getAttribute("aria-live"), "polite");
    await client.page.evaluate(beginHolding);
    await client.dragCanvas([0.5, 0.5], [0.6, 0.5]);
    await client.page.getByText("full picture is being drawn").waitFor();
    assert.equal(await client.page.locator("[data-readout=stream]").textContent(), "image, preview");
    await client.keep("waiting-still");
    await client.page.evaluate(letGo);
    await client.settled();
    assert.equal(await notice.textContent(), "");
    assert.deepEqual(client.problems, []);
    await client.close();
  });

  test("what needs the server says so while it is away, and works when it is back", async () => {
    const client = await stage.fresh();
    await stage.server.stop("SIGKILL");
    await client.page.getByText("The server does not answer").waitFor();
    await client.button("Save a picture").click();
    await client.toast(/picture cannot be saved: the server is not connected/).waitFor();
    await client.button("Export a surface").click();
    await client.button("PLY", true).click();
    await client.toast(/surface cannot be exported: the server is not connected/).waitFor();
    const box = await client.canvas.boundingBox();
    await client.page.mouse.click((box?.x ?? 0) + 60, (box?.y ?? 0) + (box?.height ?? 0) / 2);
    await client.toast(/values at the point cannot be read: the server is not connected/).waitFor();
    await client.keep("waiting-away");
    await stage.server.start();
    await client.connected();
    await client.settled();
    const [file] = await Promise.all([client.page.waitForEvent("download"), client.button("Save a picture").click()]);
    assert.match(file.suggestedFilename(), /\.png$/);
    assert.deepEqual(client.problems, []);
    await client.close();
  });
});
