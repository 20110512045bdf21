import {
  axisView,
  center,
  defaultView,
  orbit,
  pan,
  withinReach,
  withParallel,
  zoom,
  type AxisView,
  type Bounds,
  type ViewCamera,
} from "../model/camera";
import { cameraOf } from "../model/model";
import { sameDataset } from "../model/opening";
import type { Vec3 } from "../generated/protocol";
import type { Deps } from "./deps";

const NOTHING_THERE =
  "Nothing is drawn at the cursor. Double-click a surface to center the view on it. Press R to show everything that is drawn, or Shift-R to show the whole bounding box";

interface Turn {
  dataset: string | undefined;
  dx: number;
  dy: number;
  gesture: string;
}

const NO_TURN: Turn = { dataset: undefined, dx: 0, dy: 0, gesture: "" };

export class CameraCommands {
  /** Turns that wait until the center of the orbit is known. */
  private waiting: Turn = NO_TURN;

  constructor(
    private readonly deps: Deps,
    private readonly probe: (x: number, y: number) => Promise<Vec3 | null | undefined>,
  ) {}

  /** Returns the camera of the newest scene. The shown picture may have been drawn with an older camera. */
  get(): ViewCamera | null {
    return cameraOf(this.deps.model);
  }

  /** Makes a waiting turn, and then returns the camera from which a move starts. */
  toMove(): ViewCamera | null {
    this.deps.server.editor.makeHeld();
    return this.get();
  }

  set(camera: ViewCamera, gesture?: string): void {
    this.deps.server.editor.change({ camera }, gesture);
  }

  change(change: (camera: ViewCamera) => ViewCamera, gesture?: string): void {
    const camera = this.toMove();
    if (camera !== null) this.set(change(camera), gesture);
  }

  /** Zooms about (x, y), in CSS pixels of the canvas. At the zoom limit, returns the same object `camera`. */
  zoomed(camera: ViewCamera, factor: number, x: number, y: number): ViewCamera {
    const bounds = this.bounds();
    const allowed = bounds === null ? factor : withinReach(camera, factor, bounds);
    return allowed === 1 ? camera : zoom(camera, allowed, x, y, this.deps.server.size.css);
  }

  zoomBy(factor: number): void {
    const camera = this.toMove();
    const { css } = this.deps.server.size;
    if (camera === null) return;
    const next = this.zoomed(camera, factor, css.width / 2, css.height / 2);
    if (next !== camera) this.set(next);
  }

  panBy(dx: number, dy: number, gesture: string): void {
    this.change((camera) => pan(camera, dx, dy, this.deps.server.size.css), gesture);
  }

  /** Orbits like a drag by (dx, dy) CSS pixels. `anew`: first seeks a new center at the middle of the canvas. */
  turnBy(dx: number, dy: number, gesture: string, anew: boolean): void {
    const { css } = this.deps.server.size;
    if (anew && this.get() !== null) this.turnsAbout(css.width / 2, css.height / 2);
    this.turn(dx, dy, gesture);
  }

  /** Starts an orbit about the surface point at (x, y). The coordinates are CSS pixels of the canvas. */
  turnsAbout(x: number, y: number): void {
    const { server, view } = this.deps;
    view.pivot.seek(x, y, () => server.editor.makeHeld());
    if (!view.pivot.isSought) server.editor.makeHeld();
  }

  /** Orbits by (dx, dy) CSS pixels when the center of the orbit is known, at the latest before another change. */
  turn(dx: number, dy: number, gesture: string): void {
    const dataset = this.dataset();
    const before = this.waiting.dataset === dataset ? this.waiting : NO_TURN;
    this.waiting = { dataset, dx: before.dx + dx, dy: before.dy + dy, gesture };
    const { server, view } = this.deps;
    server.editor.hold(() => this.turnNow());
    if (!view.pivot.isSought) server.editor.makeHeld();
  }

  private turnNow(): void {
    const { dataset, dx, dy, gesture } = this.waiting;
    this.waiting = NO_TURN;
    if ((dx === 0 && dy === 0) || dataset !== this.dataset()) return; // another dataset was chosen meanwhile
    const { css } = this.deps.server.size;
    this.change((camera) => orbit(camera, dx, dy, css, this.deps.view.pivot.of(camera)), gesture);
  }

  reset(wholeBox = false): void {
    const { size } = this.deps.server;
    void this.framed(wholeBox, (bounds, now) => defaultView(bounds, size.aspect, now.fov, now.parallel));
  }

  lookFrom(side: AxisView): void {
    const { size } = this.deps.server;
    void this.framed(false, (bounds, now) => axisView(side, bounds, size.aspect, now.fov, now.parallel));
  }

  toggleParallel(): void {
    this.change((camera) => withParallel(camera, !camera.parallel));
  }

  async centerOn(x: number, y: number): Promise<void> {
    const point = await this.probe(x, y);
    const camera = this.get();
    if (point === null) this.deps.tell(NOTHING_THERE);
    else if (point !== undefined && camera !== null) this.set(center(camera, point));
  }

  private async framed(wholeBox: boolean, view: (bounds: Bounds, now: ViewCamera) => ViewCamera): Promise<void> {
    const { model, server } = this.deps;
    const isCurrent = sameDataset(model);
    let bounds = this.bounds();
    if (!wholeBox && server.editor.isConnected) {
      try {
        bounds = (await server.session.call("scene.bounds", { session: server.tab.id, of: "drawn" })).bounds;
      } catch (error) {
        server.fail(error);
      }
    }
    const now = this.get();
    if (isCurrent() && bounds !== null && now !== null) this.set(server.size.clearOfCorner(view(bounds, now), bounds));
  }

  private dataset(): string | undefined {
    return this.deps.model.scene.peek()?.dataset;
  }

  private bounds(): Bounds | null {
    return this.deps.model.description.peek()?.bounds ?? null;
  }
}
