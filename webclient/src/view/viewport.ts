// The canvas for pictures and the canvas for polygons. Only the canvas with the newest frame is visible.
import type { GeometryBatch } from "../server/geometry";
import { GeometryCanvas } from "./geometry_canvas";
import { ImageCanvas } from "./image_canvas";
import type { Look } from "./look";
import type { Screen } from "./presenter";

/** Milliseconds without a change after which a view with transparent layers is drawn in full quality. */
const REST_MS = 150;
/** Milliseconds between two checks whether the picture lacks layers of depth peeling. */
const ASK_AGAIN_MS = 30;

export class Viewport implements Screen {
  private readonly images: ImageCanvas;
  private geometry: GeometryCanvas | null = null;
  private redrawRequested = false;
  private settling = 0;
  private shown: "none" | "image" | "geometry" = "none";

  constructor(
    imageCanvas: HTMLCanvasElement,
    private readonly geometryCanvas: HTMLCanvasElement,
    private readonly look: () => Look | null,
    /** Size of the canvas in device pixels. */
    private readonly size: () => { width: number; height: number },
    /** Called after redraw() has drawn polygons. `requestedAt`: time of the request (performance.now). */
    private readonly drawn: (requestedAt: number) => void,
  ) {
    this.images = new ImageCanvas(imageCanvas);
  }

  showImage(image: ImageBitmap): void {
    const { width, height } = this.size();
    this.images.show(image, width, height);
    this.switchTo("image");
  }

  showGeometry(batches: GeometryBatch[]): void {
    this.geometry ??= new GeometryCanvas(this.geometryCanvas, () => this.redraw());
    this.geometry.setBatches(batches);
    this.drawGeometry(true);
    this.switchTo("geometry");
  }

  clear(): void {
    this.switchTo("none");
  }

  /** Call after a change of camera, size, background or lights. */
  redraw(): void {
    if (this.shown !== "geometry" || this.redrawRequested) return;
    this.redrawRequested = true;
    const requestedAt = performance.now();
    requestAnimationFrame(() => {
      this.redrawRequested = false;
      if (this.shown !== "geometry") return;
      this.drawGeometry(true);
      this.drawn(requestedAt);
    });
  }

  private drawGeometry(moving: boolean): void {
    const { geometry } = this;
    const look = this.look();
    const { width, height } = this.size();
    if (look === null || geometry === null) return;
    geometry.draw(look, width, height, moving);
    window.clearTimeout(this.settling);
    if (geometry.isPeeled)
      this.settling = window.setTimeout(() => this.settle(moving), moving ? REST_MS : ASK_AGAIN_MS);
  }

  private settle(moved: boolean): void {
    if (this.shown !== "geometry" || this.geometry === null) return;
    const lacks = this.geometry.lacksLayers();
    if (lacks === null) this.settling = window.setTimeout(() => this.settle(moved), ASK_AGAIN_MS);
    else if (moved || lacks) this.drawGeometry(false);
  }

  private switchTo(kind: "none" | "image" | "geometry"): void {
    if (this.shown === kind) return;
    this.shown = kind;
    this.images.canvas.hidden = kind !== "image";
    this.geometryCanvas.hidden = kind !== "geometry";
    if (kind !== "geometry") this.geometry?.setBatches([]);
  }
}
