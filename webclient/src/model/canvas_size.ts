// The canvas in CSS pixels (for the pointer) and in device pixels (for pictures).
import { clearOf, type Bounds, type FullCamera, type Size } from "./camera";

export const SMALLEST = 16; // view side, by the contract
export const LARGEST = 8192;

/** Approximate size, including margins. */
const LEGEND: Size = { width: 110, height: 260 };

export class CanvasSize {
  css: Size = { width: 960, height: 640 };
  /** Rectangle of each legend, from the top right corner to its far end; an estimate until the legends are laid out. */
  corner: Size[] = [LEGEND];
  private ratio = 1;

  set(width: number, height: number, ratio: number): void {
    this.css = { width: Math.max(SMALLEST, width), height: Math.max(SMALLEST, height) };
    this.ratio = ratio;
  }

  get aspect(): number {
    return this.css.width / this.css.height;
  }

  /** Estimates `corner` before the legends are laid out. */
  expectLegends(count: number): void {
    const inColumn = Math.max(1, Math.floor(this.css.height / LEGEND.height));
    this.corner = Array.from({ length: count }, (_, i) => ({
      width: LEGEND.width * (1 + Math.floor(i / inColumn)),
      height: LEGEND.height * (1 + (i % inColumn)),
    }));
  }

  /** Moves the camera back if the box would lie below the legends. */
  clearOfCorner(camera: FullCamera, bounds: Bounds): FullCamera {
    return clearOf(camera, bounds, this.css, ...this.corner);
  }

  /** Picture pixels per CSS pixel, clamped to the contract's limits. */
  get pixelRatio(): number {
    return Math.min(16, Math.max(0.25, this.pixels().width / this.css.width));
  }

  /** Canvas size in device pixels, scaled by `times`; at most LARGEST. */
  pixels(times = 1): Size {
    const ratio = Math.min(times * this.ratio, LARGEST / Math.max(this.css.width, this.css.height));
    const pixels = (side: number): number => Math.max(SMALLEST, Math.round(side * ratio));
    return { width: pixels(this.css.width), height: pixels(this.css.height) };
  }
}
