// The canvas in CSS pixels (the hand's) and in device pixels (the pictures').
import type { Size } from "../camera/camera";

const SMALLEST = 16; // of a view, by the contract
const LARGEST = 8192;

export class CanvasSize {
  css: Size = { width: 960, height: 640 };
  private ratio = 1;

  set(width: number, height: number, ratio: number): void {
    this.css = { width: Math.max(SMALLEST, width), height: Math.max(SMALLEST, height) };
    this.ratio = ratio;
  }

  get aspect(): number {
    return this.css.width / this.css.height;
  }

  pixels(): Size {
    const ratio = Math.min(this.ratio, LARGEST / Math.max(this.css.width, this.css.height));
    const pixels = (side: number): number => Math.max(SMALLEST, Math.round(side * ratio));
    return { width: pixels(this.css.width), height: pixels(this.css.height) };
  }
}
