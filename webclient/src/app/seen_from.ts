// Where a scene without a camera is seen from. The server knows: it leaves room for what is written over pictures. What
// lies over the canvas, and the first turn of a hand, begin there.
import { complete, type FullCamera } from "../camera/camera";
import type { Scene } from "../generated/protocol";
import type { App } from "./app";

export class SeenFrom {
  private asked = "";
  private known: { dataset: string; camera: FullCamera } | null = null;

  constructor(private readonly app: App) {}

  /** null until it is known. */
  camera({ dataset }: Scene): FullCamera | null {
    return this.known?.dataset === dataset ? this.known.camera : null;
  }

  /** After anything that may have another camera: the scene as the server has it, or the canvas. */
  async reconsider(): Promise<void> {
    const { app } = this;
    const { scene } = app.editor;
    if (scene === null || scene.camera || !app.editor.isConnected || app.editor.isPending) return;
    const size = app.size.pixels();
    const key = JSON.stringify([scene, size]);
    if (key === this.asked) return;
    this.asked = key;
    try {
      const camera = complete(await app.session.call("scene.camera", { session: app.tab.id, ...size }));
      if (key !== this.asked) return;
      this.known = { dataset: scene.dataset, camera };
      app.store.set({ seenFrom: camera });
      app.viewport?.redraw();
    } catch {
      this.asked = ""; // the view's own failure says why
    }
  }
}
