// Fetches the camera that the server chooses for a scene without a camera, for the canvas's overlays and gestures.
import { complete } from "../model/camera";
import type { Core } from "./core";

export class SeenFrom {
  private asked = "";

  constructor(private readonly server: Core) {}

  /** Call after the scene or the canvas size has changed. */
  async reconsider(): Promise<void> {
    const { editor, model, session, size, tab } = this.server;
    const scene = model.scene.peek();
    if (scene === null || scene.camera || !editor.isConnected || editor.isPending) return;
    const pixels = size.pixels();
    const key = JSON.stringify([scene, pixels]);
    if (key === this.asked) return;
    this.asked = key;
    try {
      const camera = complete(await session.call("scene.camera", { session: tab.id, ...pixels }));
      if (key === this.asked) model.seenFrom.value = { dataset: scene.dataset, camera };
    } catch {
      this.asked = ""; // view.failed already reports why the scene cannot be drawn
    }
  }
}
