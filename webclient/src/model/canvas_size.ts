// Size of the canvas, in CSS pixels for pointer positions and in device pixels for pictures.
import type { Signal } from "@preact/signals";
import { LIMITS } from "../generated/protocol";
import { clamp } from "./numbers";
import { clearOf, type Bounds, type ViewCamera, type Size } from "./camera";

/** Smallest and largest side of a view in pixels. */
export const [SMALLEST, LARGEST] = LIMITS["view.open"].width;

/** Estimated size of a legend in CSS pixels, including margins. */
const LEGEND: Size = { width: 110, height: 260 };

/** Text size in CSS pixels, smaller than in saved pictures, because users read a page from a short distance. */
const USUAL_TEXT = 12;
export const SMALLEST_TEXT = 9;
const USUAL_HEIGHT = 560;

/** Returns the text size. A small canvas has smaller text, because text of the usual size would fill the canvas. */
export function textPixels({ width, height }: Size): number {
  return clamp((USUAL_TEXT * Math.min(height, 0.75 * width)) / USUAL_HEIGHT, SMALLEST_TEXT, USUAL_TEXT);
}

export class CanvasSize {
  /** One rectangle per legend, from the canvas's top right to the legend's lower left corner, in CSS pixels. */
  corner: Size[] = [LEGEND];
  private ratio = 1;

  /** `size`: the signal canvasSize of the model. Only this class writes the signal. */
  constructor(private readonly size: Signal<Size>) {}

  set(width: number, height: number, ratio: number): void {
    this.ratio = ratio;
    this.size.value = { width: Math.max(SMALLEST, width), height: Math.max(SMALLEST, height) };
  }

  get css(): Size {
    return this.size.peek();
  }

  get aspect(): number {
    const { width, height } = this.css;
    return width / height;
  }

  /** Estimates `corner` for `count` legends, before they are laid out. */
  expectLegends(count: number): void {
    const inColumn = Math.max(1, Math.floor(this.css.height / LEGEND.height));
    this.corner = Array.from({ length: count }, (_, i) => ({
      width: LEGEND.width * (1 + Math.floor(i / inColumn)),
      height: LEGEND.height * (1 + (i % inColumn)),
    }));
  }

  clearOfCorner(camera: ViewCamera, bounds: Bounds): ViewCamera {
    return clearOf(camera, bounds, this.css, ...this.corner);
  }

  /** Picture pixels per CSS pixel. */
  get pixelRatio(): number {
    return clamp(this.pixels().width / this.css.width, ...LIMITS["view.open"].pixel_ratio);
  }

  /** Returns the size in device pixels, multiplied by `times`. No side is larger than LARGEST. */
  pixels(times = 1): Size {
    const ratio = Math.min(times * this.ratio, LARGEST / Math.max(this.css.width, this.css.height));
    const pixels = (side: number): number => Math.max(SMALLEST, Math.round(side * ratio));
    return { width: pixels(this.css.width), height: pixels(this.css.height) };
  }
}
