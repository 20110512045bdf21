// The page's parts, wired: what the server says goes into the store, what the hand does goes to the editor.
import { GeometryDecoder, geometryReady } from "../decoders/geometry";
import { decodeImage } from "../decoders/image";
import { lightsOf } from "../display/lights";
import { backgroundColors } from "../display/background";
import type { Look } from "../display/look";
import { Presenter } from "../display/presenter";
import { Viewport } from "../display/viewport";
import type { Coloring, Scene } from "../generated/protocol";
import type { FrameHeader } from "../protocol/frame_header";
import { Disconnected } from "../protocol/rpc";
import { SceneEditor } from "../scene/editor";
import { layerName } from "../scene/layer_names";
import { ShownScenes } from "../scene/shown_scenes";
import { openSocket, postTo, socketAddress } from "../session/browser_socket";
import { Latency } from "../session/latency";
import { Player } from "../session/player";
import { Session, wordsFor } from "../session/session";
import { Access } from "./access";
import { Actions } from "./actions";
import { CanvasSize } from "./canvas_size";
import { describeDatasets } from "./datasets";
import { Histograms } from "./histograms";
import { Links } from "./links";
import { forgottenWith } from "./opening";
import { Pivot } from "./pivot";
import { playerHost } from "./player_host";
import { savedStream, savedTheme, tabSession } from "./preferences";
import { SeenFrom } from "./seen_from";
import { sessionHost } from "./session_host";
import { initialState, type AppState } from "./state";
import { Store } from "./store";
import { Streams } from "./streams";
import { Toasts } from "./toasts";

const now = (): number => performance.now();
const requestFrame = (callback: () => void): void => void requestAnimationFrame(callback);

const clock = {
  now: (): number => Date.now(),
  random: (): number => Math.random(),
  setTimeout: (callback: () => void, milliseconds: number): number => window.setTimeout(callback, milliseconds),
  clearTimeout: (timer: number): void => window.clearTimeout(timer),
};

export class App {
  readonly store = new Store<AppState>({ ...initialState, theme: savedTheme(), streamChoice: savedStream() });
  readonly toasts = new Toasts(this.store);
  readonly size = new CanvasSize();
  readonly latency = new Latency();
  readonly streams = new Streams(this);
  readonly actions = new Actions(this);
  readonly links = new Links(this);
  readonly access = new Access(this);
  readonly seenFrom = new SeenFrom(this);
  readonly pivot = new Pivot(this);
  readonly scenes = new ShownScenes();
  readonly player = new Player(playerHost(this), now);
  readonly tab = tabSession();
  /** What colourings were before they became logarithmic, by what they colour. */
  readonly beforeLog = new Map<string, Coloring>();
  readonly editor: SceneEditor;
  readonly session: Session;
  readonly histograms: Histograms;
  presenter: Presenter | null = null;
  viewport: Viewport | null = null;

  constructor() {
    this.editor = new SceneEditor(
      {
        changed: () => this.sceneChanged(),
        accepted: (revision, since, scene) => {
          this.taken(revision, scene);
          this.latency.accepted(revision, since);
          this.store.set({ revision, pending: this.editor.isPending });
          void this.seenFrom.reconsider();
        },
        refused: (error) => this.fail(error),
        gone: (layer) =>
          this.toasts.show(
            `${layerName(layer)} is gone: another window or a script has removed it. Nothing was changed`,
            "error",
          ),
        stuck: (step, error) =>
          this.toasts.show(`This cannot be ${step === "undo" ? "undone" : "redone"}. ${wordsFor(error)}`, "error"),
      },
      { now, requestFrame },
      Math.random().toString(36).slice(2, 10), // other pages of the session name their gestures otherwise
    );
    const address = socketAddress(document.baseURI);
    const post = postTo(document.baseURI);
    this.session = new Session(this.tab.id, sessionHost(this), this.editor, () => openSocket(address), post, clock);
    this.histograms = new Histograms(
      (dataset, array, time) => this.session.call("dataset.histogram", { dataset, array, time, bins: 160 }),
      () => this.store.set({ histogramsAt: now() }),
      clock.setTimeout,
    );
  }

  /** The canvases exist from here on. */
  async start(imageCanvas: HTMLCanvasElement, geometryCanvas: HTMLCanvasElement): Promise<void> {
    const viewport = new Viewport(
      imageCanvas,
      geometryCanvas,
      () => this.look(),
      () => this.size.pixels(),
      (requestedAt) => this.streams.pace.drawn(requestedAt, now()),
    );
    this.viewport = viewport;
    this.presenter = new Presenter(
      viewport,
      { image: decodeImage, geometry: new GeometryDecoder() },
      {
        arrived: (header) => this.streams.arrived(header, now()),
        acknowledge: (view, frame) => this.session.acknowledge(view, frame),
        presented: (header, bytes) => this.presented(header, bytes),
        failed: (error) => this.fail(error),
        incomplete: () => this.session.renew(),
      },
      requestFrame,
    );
    await this.links.readAddress();
    await geometryReady.catch((error: unknown) => this.fail(error as Error)); // images need none of it
    this.session.start();
    window.addEventListener("online", () => this.session.retryNow());
    window.addEventListener("offline", () => this.session.networkLost());
    window.addEventListener("hashchange", () => void this.links.follow());
    setInterval(() => this.refreshRate(), 500);
  }

  resized(width: number, height: number, pixelRatio: number): void {
    this.size.set(width, height, pixelRatio);
    this.store.set({ canvasSize: this.size.css });
    this.viewport?.redraw();
    this.session.resize();
    void this.seenFrom.reconsider();
  }

  fail(error: unknown): void {
    // The end of a connection has a notice of its own.
    if (!(error instanceof Disconnected)) this.toasts.show(wordsFor(error as Error), "error");
  }

  /** The server's revisions of the scene; the picture of one may be here before. */
  taken(revision: number, scene: Scene): void {
    this.scenes.taken(revision, scene);
    const { readout, shownDataset } = this.store.get();
    if (readout.revision === 0) return; // no picture of this session yet
    this.store.set({ shownDataset: this.scenes.of(readout.revision)?.dataset ?? shownDataset });
  }

  private sceneChanged(): void {
    const { editor, store } = this;
    const before = store.get().scene;
    store.set({
      ...forgottenWith(store.get(), editor.scene),
      scene: editor.scene,
      canUndo: editor.canUndo,
      canRedo: editor.canRedo,
      pending: editor.isPending,
    });
    this.viewport?.redraw();
    this.streams.changed(before, editor.scene);
    this.links.sceneChanged();
    void describeDatasets(this);
    void this.seenFrom.reconsider();
  }

  private look(): Look | null {
    const { description, scene } = this.store.get();
    const camera = this.actions.camera();
    if (description === null || camera === null) return null;
    const { top, bottom } = backgroundColors(scene?.background);
    const lights = lightsOf(scene?.lighting);
    return { camera, bounds: description.bounds, backgroundTop: top, backgroundBottom: bottom, lights };
  }

  private presented(header: FrameHeader, bytes: number): void {
    const at = now();
    this.latency.shown(header.revision, at);
    const { readout } = this.store.get();
    const shownFrom = this.viewport?.shown === "image" ? this.scenes.cameraOf(header.revision) : null;
    this.store.set({
      shownFrom,
      shownDataset: this.scenes.of(header.revision)?.dataset ?? this.store.get().shownDataset,
      failedRevision: null,
      readout: {
        ...readout,
        stream: this.viewport?.shown ?? "none",
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
    this.player.presented(header.time);
    this.streams.presented(header, bytes);
  }

  private refreshRate(): void {
    const { readout } = this.store.get();
    const framesPerSecond = this.latency.framesPerSecond(now());
    if (framesPerSecond !== readout.framesPerSecond) this.store.set({ readout: { ...readout, framesPerSecond } });
  }
}
