// Camera of a scene without one. The server chooses it and leaves room for annotations. Overlays of the canvas and the
// first camera gesture use it.
import { complete } from "../model/camera";
import type { Core } from "./core";

export class SeenFrom {
  private asked = "";

  constructor(private readonly server: Core) {}

  /** Call after the server's scene or the canvas has changed. */
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
      this.asked = ""; // the view reports the failure
    }
  }
}
