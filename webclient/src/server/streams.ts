// Selects the stream of the view: the user's choice, or for `auto` the stream that chooseStream() returns.
import type { Scene } from "../generated/protocol";
import { FrameKind, type FrameHeader } from "../generated/frame_header";
import { layersOf } from "../model/scalars";
import { chooseStream, hasHardwareWebGL, type Gesture, type Kind } from "./choose_stream";
import { DrawPace } from "./draw_pace";
import { LineRate } from "./line_rate";
import { PolygonBytes } from "./polygon_bytes";
import type { StreamWish } from "./session";
import type { Core } from "./core";

/** Milliseconds without a change after which a gesture has ended. */
const REST_MS = 600;
/** Assumed until the first interactive picture has arrived: bytes per pixel, and server time in milliseconds. */
const USUAL_PICTURE = { bytesOfPixel: 0.07, ms: 60 };
/** Draw times in milliseconds up to this limit are not scaled by the number of triangles. */
const SMOOTH_MS = 33;

export class Streams {
  private readonly rate = new LineRate();
  readonly pace = new DrawPace();
  private hardware: boolean | null = null;
  private gesture: Gesture = "rest";
  private resting = 0;
  private said = "";
  /** Facts of the newest interactive picture. `ms` excludes extraction, which depends on the iso-value. */
  private picture: { bytes: number; ms: number } | null = null;
  private still: { ms: number } | null = null;
  private readonly polygons = new PolygonBytes();

  constructor(private readonly server: Core) {}

  /** Call for each message, because the line rate can be measured before the frame is complete. */
  arrived(header: FrameHeader, at: number): void {
    if (this.rate.arrived(header, at)) this.reconsider();
  }

  presented({ kind, still, triangles, drawMs, encodeMs }: FrameHeader, bytes: number): void {
    const ms = drawMs + encodeMs;
    if (kind !== FrameKind.image) this.polygons.presented(bytes, triangles);
    else if (still) this.still = { ms };
    else this.picture = { bytes, ms };
    this.reconsider();
  }

  /** Call when the scene was changed by this page or another client. */
  changed(before: Scene | null, now: Scene | null): void {
    if (before === null || now === null || before === now) return;
    if (before.dataset !== now.dataset) {
      this.polygons.forget();
      this.pace.forget();
    }
    const keys = new Set([...Object.keys(before), ...Object.keys(now)]) as Set<keyof Scene>;
    const others = [...keys].some((key) => key !== "camera" && before[key] !== now[key]);
    this.gesture = others ? "value" : "camera";
    window.clearTimeout(this.resting);
    this.resting = window.setTimeout(() => {
      this.gesture = "rest";
      this.reconsider();
    }, REST_MS);
    this.reconsider();
  }

  /** Call when a measured value may have changed. */
  reconsider(): void {
    this.server.session.setStream(this.wanted());
  }

  wanted(): StreamWish {
    const streamChoice = this.server.model.streamChoice.peek();
    if (streamChoice === "auto") return { stream: this.suggested(), moving: "jpeg" };
    this.say("", "");
    if (streamChoice === "jpeg") return { stream: "image", moving: "jpeg" };
    return { stream: streamChoice, moving: "png" };
  }

  private suggested(): Kind {
    const readout = this.server.model.readout.peek();
    const { width, height } = this.server.size.pixels();
    const { triangles, extractMs } = readout;
    this.hardware ??= hasHardwareWebGL();
    const { stream, why } = chooseStream({
      current: this.server.session.stream.stream,
      gesture: this.gesture,
      lineRate: this.rate.bytesPerSecond,
      sawStill: this.still !== null,
      roundTripMs: readout.roundTripMs,
      pictureBytes: this.picture?.bytes ?? USUAL_PICTURE.bytesOfPixel * width * height,
      pictureMs: extractMs + this.pictureMs(),
      polygonBytes: this.polygons.all(triangles),
      changeBytes: this.polygons.change(triangles),
      extractMs,
      drawMs: this.drawMs(triangles),
      hardware: this.hardware,
      onlyPictures: this.onlyPictures(),
    });
    const about = `${stream} ${this.gesture} ${this.rate.bytesPerSecond === null}`;
    this.say(about, `${stream === "image" ? "Pictures" : "Polygons"}: ${why}.`);
    return stream;
  }

  /** The text stays while `about` is the same, because the numbers in the text vary with every frame. */
  private say(about: string, streamWhy: string): void {
    if (about === this.said) return;
    this.said = about;
    this.server.model.streamWhy.value = streamWhy;
  }

  private drawMs(triangles: number): number | null {
    const { milliseconds } = this.pace;
    const drawn = this.polygons.triangles;
    if (milliseconds === null || milliseconds <= SMOOTH_MS || drawn === 0) return milliseconds;
    return (milliseconds * triangles) / drawn;
  }

  /** At most the still picture's time, because the first interactive picture includes the compilation of shaders. */
  private pictureMs(): number {
    if (this.picture === null) return USUAL_PICTURE.ms;
    return Math.min(this.picture.ms, this.still?.ms ?? Infinity);
  }

  private onlyPictures(): string {
    const scene = this.server.model.scene.peek();
    if (layersOf(scene, "volume").some(([, layer]) => layer.visible !== false)) return "a volume";
    if (scene?.lighting?.on !== false && scene?.lighting?.ambient_occlusion?.on === true) return "ambient occlusion";
    return "";
  }
}
