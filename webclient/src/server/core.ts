// Interface of Server (server.ts) for the other files of this folder.
import type { Scene } from "../generated/protocol";
import type { CanvasSize } from "../model/canvas_size";
import type { Model } from "../model/model";
import type { ShownScenes } from "../model/shown_scenes";
import type { SceneEditor } from "./editor";
import type { Entry } from "./entry";
import type { Histograms } from "./histograms";
import type { Latency } from "./latency";
import type { Session, StreamWish } from "./session";

export interface FrameReceiver {
  /** Call before view.open. Frames of the new view may arrive before show(). */
  expect(): void;
  show(view: number): void;
  receive(message: ArrayBuffer): void;
}

/** Functions of the rest of the page that this folder calls. */
export interface PageCallbacks {
  background(): "dark" | "light";
  link(): Scene | null;
  /** Receiver of frames; null until the canvases exist. */
  frames(): FrameReceiver | null;
  clearPicture(): void;
  stopPlaying(): void;
  /** Called when the scene has changed, unless it has become null. */
  sceneChanged(): void;
}

export interface Core {
  readonly model: Model;
  readonly size: CanvasSize;
  readonly tab: { id: string; known: boolean };
  readonly page: PageCallbacks;
  readonly latency: Latency;
  readonly scenes: ShownScenes;
  readonly editor: SceneEditor;
  readonly session: Session;
  readonly histograms: Histograms;
  readonly entry: Entry;
  readonly streams: { wanted(): StreamWish; reconsider(): void };
  fail(error: unknown): void;
  /** Call with each scene of the server, and the revision of the scene. */
  taken(revision: number, scene: Scene): void;
}
