// Draws pictures of the image stream on a canvas. Enlarges interactive pictures that are smaller than the canvas.

export class ImageCanvas {
  private readonly context: CanvasRenderingContext2D;

  constructor(readonly canvas: HTMLCanvasElement) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("The browser has no 2-d canvas; use another browser");
    this.context = context;
  }

  // Changes the size only together with a new picture, because resizing clears a canvas.
  show(image: ImageBitmap, width: number, height: number): void {
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.context.imageSmoothingEnabled = image.width !== width;
    this.context.imageSmoothingQuality = "high";
    this.context.drawImage(image, 0, 0, width, height);
  }
}
