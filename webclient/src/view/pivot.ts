// Center of an orbit: the surface point under the cursor, otherwise the center of the drawn geometry.
import type { ViewCamera } from "../model/camera";
import type { Vec3 } from "../generated/protocol";
import type { Server } from "../server/server";

/** Milliseconds to wait for the server's answer. Later, the orbit is about the target until the answer comes. */
export const PIVOT_PATIENCE_MS = 300;

export class Pivot {
  private asked = 0;
  private known: { dataset: string; at: Vec3 } | null = null;
  /** Called when the center is known, the call fails, or PIVOT_PATIENCE_MS have passed. null: no center is sought. */
  private awaited: (() => void) | null = null;

  constructor(private readonly server: Server) {}

  /** True while turns must wait for the center. Turns about another point could move the geometry out of the window. */
  get isSought(): boolean {
    return this.awaited !== null;
  }

  /**
   * Asks the server for the center of an orbit that starts at (x, y), in CSS pixels of the canvas. `found` is called
   * once, when isSought becomes false, unless another call of seek() comes first.
   */
  seek(x: number, y: number, found: () => void): void {
    const { editor, model, session, size, tab } = this.server;
    const dataset = model.scene.peek()?.dataset;
    this.known = null;
    this.awaited = null;
    this.asked += 1;
    const turn = this.asked;
    if (dataset === undefined || !editor.isConnected) return;
    this.awaited = found;
    const finish = (): void => {
      if (turn === this.asked) this.finish();
    };
    setTimeout(finish, PIVOT_PATIENCE_MS);
    const { width, height } = size.pixels();
    const ratio = width / size.css.width;
    session.call("scene.pick", { session: tab.id, pixel: [x * ratio, y * ratio], width, height }).then(
      ({ position, center }) => {
        const at = position ?? center;
        if (turn === this.asked && at !== null) this.known = { dataset, at };
        finish();
      },
      finish, // if the call fails, the orbit is about the target
    );
  }

  of(camera: ViewCamera): Vec3 {
    return this.known !== null && this.known.dataset === this.server.model.scene.peek()?.dataset
      ? this.known.at
      : camera.target;
  }

  private finish(): void {
    const found = this.awaited;
    this.awaited = null;
    found?.();
  }
}
