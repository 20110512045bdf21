// The canvas in CSS pixels (the hand's) and in device pixels (the pictures').
import { clearOf, type Bounds, type FullCamera, type Size } from "./camera";

export const SMALLEST = 16; // of a view, by the contract
export const LARGEST = 8192;

/** About, with the room around it. */
const LEGEND: Size = { width: 110, height: 260 };

export class CanvasSize {
  css: Size = { width: 960, height: 640 };
  /** What the legends take, each a rectangle from the top right corner to its far end; until they stand, what one will. */
  corner: Size[] = [LEGEND];
  private ratio = 1;

  set(width: number, height: number, ratio: number): void {
    this.css = { width: Math.max(SMALLEST, width), height: Math.max(SMALLEST, height) };
    this.ratio = ratio;
  }

  get aspect(): number {
    return this.css.width / this.css.height;
  }

  /** Before they stand. */
  expectLegends(count: number): void {
    const inColumn = Math.max(1, Math.floor(this.css.height / LEGEND.height));
    this.corner = Array.from({ length: count }, (_, i) => ({
      width: LEGEND.width * (1 + Math.floor(i / inColumn)),
      height: LEGEND.height * (1 + (i % inColumn)),
    }));
  }

  /** The view from a little further away, where the box would lie below the legends. */
  clearOfCorner(camera: FullCamera, bounds: Bounds): FullCamera {
    return clearOf(camera, bounds, this.css, ...this.corner);
  }

  /** Pixels of pictures for one of the page's, as the contract bounds it. */
  get pixelRatio(): number {
    return Math.min(16, Math.max(0.25, this.pixels().width / this.css.width));
  }

  /** `times` as large, or as large as there may be. */
  pixels(times = 1): Size {
    const ratio = Math.min(times * this.ratio, LARGEST / Math.max(this.css.width, this.css.height));
    const pixels = (side: number): number => Math.max(SMALLEST, Math.round(side * ratio));
    return { width: pixels(this.css.width), height: pixels(this.css.height) };
  }
}
