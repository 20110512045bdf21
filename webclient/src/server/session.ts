// Opens the session and a view after each connection. If the session already exists on the server, the page joins it.
import { ErrorCode, type Notifications, type Scene, type SessionState } from "../generated/protocol";
import type { ConnectionState } from "../model/state";
import { Connection, type Clock, type SocketLike } from "./connection";
import { Disconnected, RpcError, type MethodName, type Params, type Post, type Result, type Rpc } from "./rpc";
import type { SceneEditor } from "./editor";
import type { Steps } from "./scene_history";

export interface ViewSize {
  width: number;
  height: number;
  pixel_ratio: number;
}

/** Stream requested for a view. `moving`: format of interactive pictures; still pictures are always PNG. */
export interface StreamWish {
  stream: "image" | "geometry";
  moving: "png" | "jpeg";
}

export interface SessionHost {
  firstScene(call: Caller): Promise<Scene | null>;
  viewSize(): ViewSize;
  stream(): StreamWish;
  /** Called before view.open. Frames of the new view may arrive before viewOpened(). */
  viewOpening(): void;
  /** Called when a view was opened, or with 0 when the view has ended. */
  viewOpened(view: number): void;
  opened(state: SessionState): void;
  /** The server refused to open the session or its view. */
  refused(error: Error): void;
  connection(state: ConnectionState): void;
  roundTrip(milliseconds: number): void;
  binary(message: ArrayBuffer): void;
  notified<N extends keyof Notifications>(name: N, params: Notifications[N]): void;
  failed(error: Error): void;
}

export type Caller = <M extends MethodName>(method: M, params: Params<M>) => Promise<Result<M>>;

export class Session {
  private readonly connection: Connection;
  private joining: Promise<void> = Promise.resolve();
  /** Scene passed to begin() and not sent yet. A session is opened with this scene instead of the editor's scene. */
  private chosen: Scene | null = null;
  private view = 0;
  private sentSize: ViewSize = { width: 0, height: 0, pixel_ratio: 1 };
  private sentStream: StreamWish = { stream: "image", moving: "png" };

  constructor(
    readonly id: string,
    private readonly host: SessionHost,
    private readonly editor: SceneEditor,
    open: () => SocketLike,
    post: Post,
    clock: Clock,
  ) {
    this.connection = new Connection(
      open,
      post,
      {
        state: (state) => this.stateChanged(state),
        opened: (rpc) => void this.joinOrSayWhy(rpc),
        notification: (name, params) => host.notified(name as keyof Notifications, params as never),
        binary: (message) => host.binary(message),
        roundTrip: (milliseconds) => host.roundTrip(milliseconds),
      },
      clock,
    );
  }

  /** Stream that the server was asked for last. */
  get stream(): StreamWish {
    return this.sentStream;
  }

  private get rpc(): Rpc | null {
    return this.connection.rpc;
  }

  start(): void {
    this.connection.start();
  }

  retryNow(): void {
    this.connection.retryNow();
  }

  networkLost(): void {
    this.connection.lost();
  }

  /** Rejects with Disconnected while there is no connection. */
  call<M extends MethodName>(method: M, params: Params<M>, signal?: AbortSignal): Promise<Result<M>> {
    return this.rpc === null ? Promise.reject(new Disconnected()) : this.rpc.call(method, params, signal);
  }

  acknowledge(view: number, frame: number): void {
    if (view === this.view) this.rpc?.notify("view.ack", { view, frame });
  }

  resize(): void {
    const size = this.host.viewSize();
    const sent = this.sentSize;
    const isSame = size.width === sent.width && size.height === sent.height && size.pixel_ratio === sent.pixel_ratio;
    if (!isSame) this.renew();
  }

  /** Requests the current frame of the view again. The server then sends all polygons. */
  renew(): void {
    if (this.view === 0) return;
    const size = this.host.viewSize();
    this.sentSize = size;
    this.call("view.resize", { view: this.view, ...size }).catch((error: unknown) => this.report(error));
  }

  setStream(wish: StreamWish): void {
    if (this.view === 0 || (wish.stream === this.sentStream.stream && wish.moving === this.sentStream.moving)) return;
    this.sentStream = wish;
    this.call("view.stream", { view: this.view, ...wish }).catch((error: unknown) => this.report(error));
  }

  /** Shows this scene. Opens a session if none is open: the page had no scene, or the server refused the session. */
  async begin(scene: Scene): Promise<void> {
    this.chosen = scene;
    await this.joining;
    if (this.chosen !== scene) return; // another scene was chosen meanwhile
    if (!this.editor.isConnected) await this.open();
    else {
      this.chosen = null;
      await this.editor.propose(scene);
    }
  }

  /** Tries again to open the session that the server has refused. */
  async open(): Promise<void> {
    const { rpc, joining } = this;
    await joining;
    if (this.joining !== joining) return; // another call to open() continues
    if (rpc !== null && rpc === this.rpc && !this.editor.isConnected) await this.joinOrSayWhy(rpc);
  }

  private stateChanged(state: ConnectionState): void {
    if (state.kind !== "open") {
      this.setView(0);
      this.editor.disconnected();
    }
    this.host.connection(state);
  }

  private joinOrSayWhy(rpc: Rpc): Promise<void> {
    const { chosen } = this;
    this.joining = this.join(rpc, chosen).catch((error: unknown) => {
      if (this.rpc !== rpc) return;
      if (this.chosen === chosen) this.chosen = null; // the next attempt uses the editor's scene
      this.setView(0);
      this.editor.disconnected();
      this.host.refused(error as Error);
    });
    return this.joining;
  }

  private async join(rpc: Rpc, chosen: Scene | null): Promise<void> {
    const session = this.id;
    const call: Caller = (method, params) => rpc.call(method, params);
    const scene = chosen ?? this.editor.scene ?? (await this.host.firstScene(call));
    if (this.rpc !== rpc || scene === null) return;
    const steps = chosen === null ? await this.stepsThatFit(call, scene) : {};
    if (this.rpc !== rpc) return;
    const state = await rpc.call("session.open", { session, scene, ...steps });
    if (this.rpc !== rpc) return;
    if (chosen !== null) this.editor.forget();
    if (this.chosen === chosen) this.chosen = null;
    this.editor.connected(
      {
        patch: (patch, gesture) => rpc.call("scene.patch", { session, patch, gesture }),
        undo: () => rpc.call("scene.undo", { session }),
        redo: () => rpc.call("scene.redo", { session }),
        get: () => rpc.call("scene.get", { session }),
      },
      state,
    );
    this.host.opened(state);
    // If another page opened the session earlier, the session has the scene of that page.
    if (chosen !== null && chosen.dataset !== state.scene.dataset) void this.editor.propose(chosen);
    this.sentSize = this.host.viewSize();
    this.sentStream = this.host.stream();
    this.host.viewOpening();
    const { view } = await rpc.call("view.open", { session, ...this.sentSize, ...this.sentStream });
    if (this.rpc !== rpc) return;
    this.setView(view);
    this.resize(); // size and stream may have changed since view.open was sent
    this.setStream(this.host.stream());
  }

  /** Asks for the server's message limit first, because the server closes the connection if a message is too long. */
  private async stepsThatFit(call: Caller, scene: Scene): Promise<Steps> {
    const { undo, redo } = this.editor.stepsAround(scene);
    if (undo.length + redo.length === 0) return { undo, redo };
    const { limits } = await call("server.info", {});
    return this.editor.stepsAround(scene, limits.message_bytes);
  }

  private setView(view: number): void {
    this.view = view;
    this.host.viewOpened(view);
  }

  private report(error: unknown): void {
    if (!(error instanceof Disconnected)) this.host.failed(error as Error);
  }
}

/**
 * Returns the text of an error for the user: the server's reason, and the path of the refused member of the scene. For
 * an internal error of the server, the text has the request id, which is also in the server's log.
 */
export function wordsFor(error: Error): string {
  if (!(error instanceof RpcError) || typeof error.data !== "object" || error.data === null) return error.message;
  const { reason, path, request } = error.data as { reason?: unknown; path?: unknown; request?: unknown };
  const words = typeof reason === "string" && reason !== "" ? reason : error.message;
  const sentence = words.charAt(0).toUpperCase() + words.slice(1);
  if (error.code === ErrorCode.InternalError && typeof request === "string") return `${sentence} (request ${request})`;
  // The text of a schema error already begins with the path.
  return typeof path === "string" && !words.startsWith(path) ? `${sentence} (${path})` : sentence;
}
