// Draws pictures of the image stream over the whole canvas. Smaller (interactive) ones are enlarged.

export class ImageCanvas {
  private readonly context: CanvasRenderingContext2D;

  constructor(readonly canvas: HTMLCanvasElement) {
    const context = canvas.getContext("2d", { alpha: false });
    if (context === null) throw new Error("This browser draws no 2-d canvas");
    this.context = context;
  }

  // Resizing blanks a canvas, so it is resized only together with a new picture.
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
