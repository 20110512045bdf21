// Center of an orbit: the surface point under the cursor, otherwise the center of the drawn geometry.
import type { FullCamera } from "../model/camera";
import type { Vec3 } from "../generated/protocol";
import type { Server } from "../server/server";

export class Pivot {
  private asked = 0;
  private known: { dataset: string; at: Vec3 } | null = null;

  constructor(private readonly server: Server) {}

  /** (x, y) is the start of the orbit, in CSS pixels of the canvas. */
  seek(x: number, y: number): void {
    const { editor, model, session, size, tab } = this.server;
    const dataset = model.scene.peek()?.dataset;
    this.known = null;
    this.asked += 1;
    const turn = this.asked;
    if (dataset === undefined || !editor.isConnected) return;
    const { width, height } = size.pixels();
    const ratio = width / size.css.width;
    session.call("scene.pick", { session: tab.id, pixel: [x * ratio, y * ratio], width, height }).then(
      ({ position, centre }) => {
        const at = position ?? centre;
        if (turn === this.asked && at !== null) this.known = { dataset, at };
      },
      () => undefined, // if the call fails, the orbit is about the target
    );
  }

  of(camera: FullCamera): Vec3 {
    return this.known !== null && this.known.dataset === this.server.model.scene.peek()?.dataset
      ? this.known.at
      : camera.target;
  }
}
