// What the parts of this folder reach of each other; server.ts is all of it.
import type { Scene } from "../generated/protocol";
import type { CanvasSize } from "../model/canvas_size";
import type { Model } from "../model/model";
import type { ShownScenes } from "../model/shown_scenes";
import type { SceneEditor } from "./editor";
import type { Entry } from "./entry";
import type { Histograms } from "./histograms";
import type { Latency } from "./latency";
import type { Session, StreamWish } from "./session";

/** Where the frames of a view go. */
export interface FrameReceiver {
  /** Frames of a view that is not named yet may come. */
  expect(): void;
  show(view: number): void;
  receive(message: ArrayBuffer): void;
}

/** What the server is told of the page around it. */
export interface Page {
  background(): "dark" | "light";
  /** The scene of the link that the page was opened with. */
  link(): Scene | null;
  /** null before there are canvases. */
  frames(): FrameReceiver | null;
  clearPicture(): void;
  /** Which canvas is seen. */
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
  /** The server has a revision of the scene. */
  taken(revision: number, scene: Scene): void;
}
