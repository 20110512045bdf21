// The page's access to the server: one session, its scene and its calls. Results are written into the model.
import type { CanvasSize } from "../model/canvas_size";
import { layerName } from "../model/layer_names";
import { update, type Model } from "../model/model";
import { forgottenWith } from "../model/opening";
import { ShownScenes } from "../model/shown_scenes";
import { showToast } from "../model/toasts";
import type { Scene } from "../generated/protocol";
import { openSocket, postTo, socketAddress } from "./browser_socket";
import type { Core, PageCallbacks } from "./core";
import { describeDataset } from "./datasets";
import { SceneEditor } from "./editor";
import { Entry } from "./entry";
import { FrameKind, type FrameHeader } from "../generated/frame_header";
import { Histograms } from "./histograms";
import { Latency } from "./latency";
import { Disconnected } from "./rpc";
import { SeenFrom } from "./seen_from";
import { Session, wordsFor } from "./session";
import { sessionHost } from "./session_host";
import { Streams } from "./streams";

const now = (): number => performance.now();

const clock = {
  now: (): number => Date.now(),
  random: (): number => Math.random(),
  setTimeout: (callback: () => void, milliseconds: number): number => window.setTimeout(callback, milliseconds),
  clearTimeout: (timer: number): void => window.clearTimeout(timer),
};

/** A power of two, because the server then answers from the stored histogram and reads no values. */
const HISTOGRAM_BINS = 128;
const RATE_MS = 500;

export class Server implements Core {
  readonly latency = new Latency();
  readonly scenes = new ShownScenes();
  readonly editor: SceneEditor;
  readonly session: Session;
  readonly histograms: Histograms;
  readonly streams: Streams;
  readonly entry: Entry;
  readonly seenFrom: SeenFrom;

  constructor(
    readonly model: Model,
    readonly size: CanvasSize,
    readonly tab: { id: string; known: boolean },
    readonly page: PageCallbacks,
  ) {
    this.editor = new SceneEditor(
      model,
      {
        changed: (before) => this.sceneChanged(before),
        accepted: (revision, since, scene) => this.accepted(revision, since, scene),
        refused: (error) => this.fail(error),
        gone: (layer) =>
          showToast(
            model,
            `${layerName(layer)} no longer exists: another window or a script has removed the layer. Nothing was changed`,
            "error",
          ),
        stuck: (step, error) =>
          showToast(
            model,
            `The change cannot be ${step === "undo" ? "undone" : "redone"}. ${wordsFor(error)}`,
            "error",
          ),
      },
      { now, requestFrame: (callback) => void requestAnimationFrame(callback) },
      Math.random().toString(36).slice(2, 10), // distinguishes the gestures of several pages in one session
    );
    const address = socketAddress(document.baseURI);
    const post = postTo(document.baseURI);
    this.session = new Session(tab.id, sessionHost(this), this.editor, () => openSocket(address), post, clock);
    this.histograms = new Histograms(
      (dataset, array, time) => this.session.call("dataset.histogram", { dataset, array, time, bins: HISTOGRAM_BINS }),
      clock.setTimeout,
    );
    this.streams = new Streams(this);
    this.entry = new Entry(model, () => this.session.retryNow());
    this.seenFrom = new SeenFrom(this);
  }

  start(): void {
    this.session.start();
    window.addEventListener("online", () => this.session.retryNow());
    window.addEventListener("offline", () => this.session.networkLost());
    setInterval(() => this.refreshRate(), RATE_MS);
  }

  resized(): void {
    this.session.resize();
    void this.seenFrom.reconsider();
  }

  fail(error: unknown): void {
    // The page shows a lost connection separately.
    if (!(error instanceof Disconnected)) showToast(this.model, wordsFor(error as Error), "error");
  }

  taken(revision: number, scene: Scene): void {
    this.scenes.taken(revision, scene);
    const { readout, shownScene } = this.model;
    const shown = readout.peek().revision;
    if (shown !== 0) shownScene.value = this.scenes.of(shown); // 0: no picture of this session
  }

  /** `bytes`: size of the messages of the frame. */
  presented(header: FrameHeader, bytes: number): void {
    const { model } = this;
    const at = now();
    this.latency.shown(header.revision, at);
    update(model, {
      shownScene: this.scenes.of(header.revision),
      failedRevision: null,
      readout: {
        ...model.readout.peek(),
        stream: header.kind === FrameKind.image ? "image" : "geometry",
        still: header.still,
        latencyMs: this.latency.last,
        framesPerSecond: this.latency.framesPerSecond(at),
        extractMs: header.extractMs,
        drawMs: header.drawMs,
        encodeMs: header.encodeMs,
        triangles: header.triangles,
        width: header.width,
        height: header.height,
        bytes,
        time: header.time,
        revision: header.revision,
        frame: header.frame,
      },
    });
    this.streams.presented(header, bytes);
  }

  private accepted(revision: number, since: number, scene: Scene): void {
    this.taken(revision, scene);
    this.latency.accepted(revision, since);
    update(this.model, { revision });
    void this.seenFrom.reconsider();
  }

  private sceneChanged(before: Scene | null): void {
    const { model } = this;
    const scene = model.scene.peek();
    update(model, forgottenWith({ scene: before, upcoming: model.upcoming.peek() }, scene));
    this.streams.changed(before, scene);
    if (scene !== before && scene !== null) this.page.sceneChanged();
    if (before?.dataset !== scene?.dataset) void describeDataset(this);
    void this.seenFrom.reconsider();
  }

  private refreshRate(): void {
    const readout = this.model.readout.peek();
    const framesPerSecond = this.latency.framesPerSecond(now());
    if (framesPerSecond !== readout.framesPerSecond) this.model.readout.value = { ...readout, framesPerSecond };
  }
}
