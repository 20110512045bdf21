// The two canvases, of which the one that the newest frame is for is seen.
import type { GeometryBatch } from "../decoders/geometry";
import { GeometryCanvas, type Look } from "./geometry_canvas";
import { ImageCanvas } from "./image_canvas";
import type { Screen } from "./presenter";

export class Viewport implements Screen {
  private readonly images: ImageCanvas;
  private geometry: GeometryCanvas | null = null;
  private redrawRequested = false;
  shown: "none" | "image" | "geometry" = "none";

  constructor(
    imageCanvas: HTMLCanvasElement,
    private readonly geometryCanvas: HTMLCanvasElement,
    /** How the geometry is looked at now; null before there is a scene. */
    private readonly look: () => Look | null,
    /** In device pixels. */
    readonly size: () => { width: number; height: number },
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
    this.drawGeometry();
    this.switchTo("geometry");
  }

  /** Nothing is shown until the next frame. */
  clear(): void {
    this.switchTo("none");
  }

  /** After the camera, the size or the background changed: polygons that are here already are drawn anew. */
  redraw(): void {
    if (this.shown !== "geometry" || this.redrawRequested) return;
    this.redrawRequested = true;
    requestAnimationFrame(() => {
      this.redrawRequested = false;
      if (this.shown === "geometry") this.drawGeometry();
    });
  }

  private drawGeometry(): void {
    const look = this.look();
    const { width, height } = this.size();
    if (look !== null) this.geometry?.draw(look, width, height);
  }

  private switchTo(kind: "none" | "image" | "geometry"): void {
    if (this.shown === kind) return;
    this.shown = kind;
    this.images.canvas.hidden = kind !== "image";
    this.geometryCanvas.hidden = kind !== "geometry";
    if (kind !== "geometry") this.geometry?.setBatches([]);
  }
}
