// Shows the server's frames: decodes messages, draws the newest frame in an animation frame, acknowledges each frame.
import { MissingArrays, type GeometryBatch } from "../server/geometry";
import { EarlyFrames } from "./early_frames";
import { readFrameHeader, FrameKind, type FrameHeader } from "../generated/frame_header";
import { Pieces } from "../server/pieces";

export interface Screen {
  showImage(image: ImageBitmap): void;
  showGeometry(batches: GeometryBatch[]): void;
}

export interface PresenterEvents {
  /** A message of any view has arrived. The message may be one piece of a frame. */
  arrived(header: FrameHeader): void;
  acknowledge(view: number, frame: number): void;
  presented(header: FrameHeader, bytes: number): void;
  failed(error: Error): void;
  /** A frame refers to polygons of an earlier frame that could not be decoded. All polygons must be requested again. */
  incomplete(): void;
}

export interface Decoders {
  image(message: ArrayBuffer): Promise<ImageBitmap>;
  /** Decodes the frames of one view. Call clear() before frames of another view. */
  geometry: { decode(message: ArrayBuffer): GeometryBatch | null; clear(): void };
}

interface ReadyFrame {
  header: FrameHeader;
  bytes: number;
  draw(): void;
  release(): void;
}

export class Presenter {
  private view = 0;
  private readonly pieces = new Pieces();
  private lastFrame = 0;
  private ready: ReadyFrame | null = null;
  private arriving: { frame: number; batches: GeometryBatch[]; bytes: number; damaged: boolean } | null = null;
  private frameRequested = false;
  /** Frames of the view that is being opened; null if no view is being opened. */
  private early: EarlyFrames | null = null;

  constructor(
    private readonly screen: Screen,
    private readonly decoders: Decoders,
    private readonly events: PresenterEvents,
    private readonly requestFrame: (callback: () => void) => void,
  ) {}

  /** Call before view.open. Keeps the frames that arrive before show() is called with the id of the view. */
  expect(): void {
    this.show(0);
    this.early = new EarlyFrames();
  }

  /** Shows only frames of this view from now on. 0: no frames at all. */
  show(view: number): void {
    const early = this.early?.of(view) ?? [];
    this.early = null;
    this.view = view;
    this.lastFrame = 0;
    this.arriving = null;
    this.pieces.clear();
    this.decoders.geometry.clear();
    this.ready?.release();
    this.ready = null;
    for (const message of early) this.take(readFrameHeader(message), message);
  }

  receive(message: ArrayBuffer): void {
    try {
      const header = readFrameHeader(message);
      this.events.arrived(header);
      if (this.early === null) this.take(header, message);
      else this.early.keep(header, message);
    } catch (error) {
      this.events.failed(error as Error);
    }
  }

  private take(header: FrameHeader, message: ArrayBuffer): void {
    if (header.view !== this.view) return;
    try {
      const whole = this.pieces.add(header, message);
      if (whole !== null) this.receiveWhole(readFrameHeader(whole), whole);
    } catch (error) {
      this.events.acknowledge(header.view, header.frame); // like a damaged image, see receiveImage
      this.events.failed(error as Error);
    }
  }

  private receiveWhole(header: FrameHeader, message: ArrayBuffer): void {
    if (header.kind === FrameKind.image) this.receiveImage(header, message);
    else if (header.kind === FrameKind.geometry) this.receiveGeometry(header, message);
    else
      throw new Error(`The server sends frames of kind ${header.kind}, which this page does not know. Reload the page`);
  }

  private receiveImage(header: FrameHeader, message: ArrayBuffer): void {
    const view = this.view;
    this.decoders.image(message).then(
      (image) => {
        if (view !== this.view) image.close();
        else {
          const draw = (): void => this.screen.showImage(image);
          this.offer({ header, bytes: message.byteLength, draw, release: () => image.close() });
        }
      },
      (error: unknown) => {
        // Without this acknowledgement, the server would not send the next frame.
        if (view === this.view) this.events.acknowledge(view, header.frame);
        this.events.failed(error as Error);
      },
    );
  }

  private receiveGeometry(header: FrameHeader, message: ArrayBuffer): void {
    if (header.firstOfFrame || this.arriving?.frame !== header.frame)
      this.arriving = { frame: header.frame, batches: [], bytes: 0, damaged: false };
    const { arriving } = this;
    try {
      const batch = this.decoders.geometry.decode(message);
      if (batch !== null) arriving.batches.push(batch);
    } catch (error) {
      arriving.damaged = true;
      if (error instanceof MissingArrays) this.events.incomplete();
      this.events.failed(error as Error);
    }
    arriving.bytes += message.byteLength;
    if (!header.lastOfFrame) return;
    this.arriving = null;
    if (arriving.damaged) {
      this.events.acknowledge(header.view, header.frame); // like a damaged image, see receiveImage
      return;
    }
    const draw = (): void => this.screen.showGeometry(arriving.batches);
    this.offer({ header, bytes: arriving.bytes, draw, release: () => undefined });
  }

  // Skips a frame that was decoded later than a newer frame.
  private offer(frame: ReadyFrame): void {
    const stale = frame.header.frame <= this.lastFrame;
    if (stale || (this.ready !== null && this.ready.header.frame > frame.header.frame)) {
      this.supersede(frame);
      return;
    }
    if (this.ready !== null) this.supersede(this.ready);
    this.ready = frame;
    if (this.frameRequested) return;
    this.frameRequested = true;
    this.requestFrame(() => {
      this.frameRequested = false;
      this.present();
    });
  }

  private supersede(frame: ReadyFrame): void {
    frame.release();
    this.events.acknowledge(frame.header.view, frame.header.frame);
  }

  private present(): void {
    const frame = this.ready;
    if (frame === null) return;
    this.ready = null;
    this.lastFrame = frame.header.frame;
    try {
      frame.draw();
      this.events.presented(frame.header, frame.bytes);
    } catch (error) {
      this.events.failed(error as Error); // draw() throws if the browser has no WebGL2
    }
    frame.release();
    this.events.acknowledge(frame.header.view, frame.header.frame);
  }
}
