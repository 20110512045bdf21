// Shared interface of the parts of this folder; Server in server.ts implements it.
import type { Scene } from "../generated/protocol";
import type { CanvasSize } from "../model/canvas_size";
import type { Model } from "../model/model";
import type { ShownScenes } from "../model/shown_scenes";
import type { SceneEditor } from "./editor";
import type { Entry } from "./entry";
import type { Histograms } from "./histograms";
import type { Latency } from "./latency";
import type { Session, StreamWish } from "./session";

/** Receives the frames of a view. */
export interface FrameReceiver {
  /** A view is being opened: its frames may arrive before show(). */
  expect(): void;
  show(view: number): void;
  receive(message: ArrayBuffer): void;
}

/** The page, as used by the server's code. */
export interface Page {
  background(): "dark" | "light";
  /** Scene of the link that opened the page; null without one. */
  link(): Scene | null;
  /** null until the canvases exist. */
  frames(): FrameReceiver | null;
  clearPicture(): void;
  /** The visible canvas. */
  shown(): "none" | "image" | "geometry";
  stopPlaying(): void;
}

export interface Core {
  readonly model: Model;
  readonly size: CanvasSize;
  readonly tab: { id: string; known: boolean };
  readonly page: Page;
  readonly latency: Latency;
  readonly scenes: ShownScenes;
  readonly editor: SceneEditor;
  readonly session: Session;
  readonly histograms: Histograms;
  readonly entry: Entry;
  readonly streams: { current(): StreamWish; reconsider(): void };
  fail(error: unknown): void;
  /** The server's scene at this revision. */
  taken(revision: number, scene: Scene): void;
}
