// Where a scene without a camera is seen from. The server knows: it leaves room for what is written over pictures. What
// lies over the canvas, and the first turn of a hand, begin there.
import { complete } from "../model/camera";
import type { Core } from "./core";

export class SeenFrom {
  private asked = "";

  constructor(private readonly server: Core) {}

  /** After anything that may have another camera: the scene as the server has it, or the canvas. */
  async reconsider(): Promise<void> {
    const { editor, model, session, size, tab } = this.server;
    const { scene } = editor;
    if (scene === null || scene.camera || !editor.isConnected || editor.isPending) return;
    const pixels = size.pixels();
    const key = JSON.stringify([scene, pixels]);
    if (key === this.asked) return;
    this.asked = key;
    try {
      const camera = complete(await session.call("scene.camera", { session: tab.id, ...pixels }));
      if (key === this.asked) model.seenFrom.value = { dataset: scene.dataset, camera };
    } catch {
      this.asked = ""; // the view's own failure says why
    }
  }
}
