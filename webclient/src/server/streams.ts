// Which stream the view gets: the person's choice, or for `auto` what the scene, the hand and the line suggest.
import type { Scene } from "../generated/protocol";
import { KIND_IMAGE, type FrameHeader } from "./frame_header";
import { layersOf } from "../model/scalars";
import { chooseStream, hasHardwareWebGL, type Gesture, type Kind } from "./choose_stream";
import { DrawPace } from "./draw_pace";
import { LineRate } from "./line_rate";
import type { StreamWish } from "./session";
import type { Core } from "./core";

/** After it a hand has let go. */
const REST_MS = 600;
/** Before the first of a kind has come. */
const USUAL_PICTURE = { bytesOfPixel: 0.07, ms: 60 };
const USUAL_TRIANGLE_BYTES = 8;
/** What the browser draws as soon costs nothing more for fewer triangles. */
const SMOOTH_MS = 33;

export class Streams {
  private readonly rate = new LineRate();
  readonly pace = new DrawPace();
  private hardware: boolean | null = null;
  private asked: StreamWish | null = null;
  private gesture: Gesture = "rest";
  private resting = 0;
  private said = "";
  /** Without the extraction, which changes from one value to the next. */
  private picture: { bytes: number; ms: number } | null = null;
  private still: { ms: number } | null = null;
  private polygons: { bytes: number; triangles: number } | null = null;

  constructor(private readonly server: Core) {}

  /** For a view that is about to be opened. */
  current(): StreamWish {
    this.asked = this.wanted();
    return this.asked;
  }

  /** A message of the view: the rate may be known by it, long before all of its frame is here. */
  arrived(header: FrameHeader, at: number): void {
    if (this.rate.arrived(header, at)) this.reconsider();
  }

  presented({ kind, still, triangles, drawMs, encodeMs }: FrameHeader, bytes: number): void {
    const ms = drawMs + encodeMs;
    if (kind !== KIND_IMAGE) this.polygons = { bytes, triangles };
    else if (still) this.still = { ms };
    else this.picture = { bytes, ms };
    this.reconsider();
  }

  /** The hand, or another window, has changed the scene. */
  changed(before: Scene | null, now: Scene | null): void {
    if (before === null || now === null || before === now) return;
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

  /** What it goes by may have become known. */
  reconsider(): void {
    const wanted = this.wanted();
    if (wanted.stream === this.asked?.stream && wanted.moving === this.asked.moving) return;
    this.asked = wanted;
    this.server.session.setStream(wanted);
  }

  private wanted(): StreamWish {
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
    const held = this.polygons;
    this.hardware ??= hasHardwareWebGL();
    const { stream, why } = chooseStream({
      current: this.asked?.stream ?? "image",
      gesture: this.gesture,
      lineRate: this.rate.bytesPerSecond,
      sawStill: this.still !== null,
      roundTripMs: readout.roundTripMs,
      pictureBytes: this.picture?.bytes ?? USUAL_PICTURE.bytesOfPixel * width * height,
      pictureMs: extractMs + this.pictureMs(),
      polygonBytes:
        held === null || held.triangles === 0
          ? USUAL_TRIANGLE_BYTES * triangles
          : (held.bytes / held.triangles) * triangles,
      extractMs,
      drawMs: this.drawMs(triangles),
      hardware: this.hardware,
      onlyPictures: this.onlyPictures(),
    });
    const about = `${stream} ${this.gesture} ${this.rate.bytesPerSecond === null}`;
    this.say(about, `${stream === "image" ? "Pictures" : "Polygons"}: ${why}.`);
    return stream;
  }

  /** Once about the same: the numbers differ a little with every frame. */
  private say(about: string, streamWhy: string): void {
    if (about === this.said) return;
    this.said = about;
    this.server.model.streamWhy.value = streamWhy;
  }

  /** As seen, or of so many triangles more. */
  private drawMs(triangles: number): number | null {
    const { milliseconds } = this.pace;
    const drawn = this.polygons?.triangles ?? 0;
    if (milliseconds === null || milliseconds <= SMOOTH_MS || drawn === 0) return milliseconds;
    return (milliseconds * triangles) / drawn;
  }

  /** The first one waits for programs to be compiled; but none takes longer than its still. */
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
