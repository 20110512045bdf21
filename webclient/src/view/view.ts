// The canvases of the page. Shows the server's frames, and draws polygons again when the camera or the lights change.
import { computed } from "@preact/signals";
import { backgroundColors } from "../model/background";
import { lightsOf } from "../model/lights";
import { cameraOf, type Model } from "../model/model";
import type { FrameHeader } from "../generated/frame_header";
import { GeometryDecoder, geometryReady } from "../server/geometry";
import { decodeImage } from "../server/image";
import type { Server } from "../server/server";
import type { Look } from "./look";
import { Pivot } from "./pivot";
import { Presenter } from "./presenter";
import { Viewport } from "./viewport";

const now = (): number => performance.now();

function lookOf(model: Model): Look | null {
  const camera = cameraOf(model);
  const bounds = model.description.value?.bounds;
  if (bounds === undefined || camera === null) return null;
  const { top, bottom } = backgroundColors(model.scene.value?.background);
  const lights = lightsOf(model.scene.value?.lighting);
  return { camera, bounds, backgroundTop: top, backgroundBottom: bottom, lights };
}

export class View {
  readonly pivot: Pivot;
  presenter: Presenter | null = null;
  private viewport: Viewport | null = null;

  constructor(
    private readonly model: Model,
    private readonly server: Server,
    private readonly presented: (header: FrameHeader, bytes: number) => void,
  ) {
    this.pivot = new Pivot(server);
  }

  async attach(imageCanvas: HTMLCanvasElement, geometryCanvas: HTMLCanvasElement): Promise<void> {
    const { model, server } = this;
    const look = computed(() => lookOf(model));
    const viewport = new Viewport(
      imageCanvas,
      geometryCanvas,
      () => look.peek(),
      () => server.size.pixels(),
      (requestedAt) => server.streams.pace.drawn(requestedAt, now()),
    );
    this.viewport = viewport;
    this.presenter = new Presenter(
      viewport,
      { image: decodeImage, geometry: new GeometryDecoder() },
      {
        arrived: (header) => server.streams.arrived(header, now()),
        acknowledge: (view, frame) => server.session.acknowledge(view, frame),
        presented: (header, bytes) => this.presented(header, bytes),
        failed: (error) => server.fail(error),
        incomplete: () => server.session.renew(),
      },
      (callback) => void requestAnimationFrame(callback),
    );
    look.subscribe(() => viewport.redraw());
    await geometryReady.catch((error: unknown) => server.fail(error)); // pictures can be shown without this decoder
  }

  /** Call when the canvas has a new size, in CSS pixels. `pixelRatio`: device pixels per CSS pixel. */
  resized(width: number, height: number, pixelRatio: number): void {
    this.server.size.set(width, height, pixelRatio);
    this.viewport?.redraw();
    this.server.resized();
  }

  clear(): void {
    this.viewport?.clear();
  }
}
