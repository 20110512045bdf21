// The page's state; model.ts makes a signal of each member.
import type { FullCamera, Size } from "./camera";
import type {
  CellExtremes,
  DatasetDescription,
  EmptyLayer,
  Methods,
  ProbeResult,
  Range,
  Scene,
} from "../generated/protocol";
import type { Box } from "./overlay_room";

export type ConnectionState =
  | { kind: "connecting"; attempt: number }
  | { kind: "open" }
  | { kind: "waiting"; attempt: number; retryAt: number }
  | { kind: "closed" };

/** Why a reachable server opens no socket. */
export type Refusal =
  | { kind: "token" }
  /** Another reason, as the server or a proxy states it. */
  | { kind: "refused"; words: string }
  /** HTTP calls are answered, so something in between blocks WebSockets. */
  | { kind: "no-socket" };

export type StreamChoice = "image" | "jpeg" | "geometry" | "auto";
export type Theme = "system" | "dark" | "light";

export interface Readout {
  stream: "none" | "image" | "geometry";
  still: boolean;
  framesPerSecond: number;
  /** From the input to the picture that shows it. */
  latencyMs: number | null;
  roundTripMs: number | null;
  extractMs: number;
  drawMs: number;
  encodeMs: number;
  triangles: number;
  width: number;
  height: number;
  bytes: number;
  time: number;
  revision: number;
  frame: number;
}

export interface Toast {
  id: number;
  kind: "error" | "info";
  text: string;
}

export interface Probe {
  result: ProbeResult;
  time: number;
}

export interface Histogram {
  range: Range;
  counts: number[];
  invalid: number;
  /** Extremes over the cells of the array, or of the array that it was made from. */
  cells?: CellExtremes | undefined;
}

export interface PageState {
  connection: ConnectionState;
  draining: boolean;
  /** Why a reachable server opens no socket. */
  refusal: Refusal | null;
  /** A sentence shown instead of the canvas: nothing can be drawn. */
  fatal: string | null;
  server: Methods["server.info"]["result"] | null;
  datasets: Methods["dataset.list"]["result"] | null;
  description: DatasetDescription | null;
  /** Dataset whose description is being fetched. */
  describing: string | null;
  /** The chosen dataset, until the scene is of it. */
  chosen: string | null;
  /** The description of a chosen dataset, until the scene is of it. */
  upcoming: DatasetDescription | null;
  /** Dataset of the shown picture. */
  shownDataset: string | null;
  /** Scene of the shown picture, if known. */
  shownScene: Scene | null;
  scene: Scene | null;
  /** The server's camera for a scene of the dataset without one. */
  seenFrom: { dataset: string; camera: FullCamera } | null;
  /** Camera of the shown picture; null if this page draws it with the newest camera. */
  shownFrom: FullCamera | null;
  canUndo: boolean;
  canRedo: boolean;
  /** The server has not accepted the newest change yet. */
  pending: boolean;
  /** Revision of the newest change that the server has accepted. */
  revision: number;
  streamChoice: StreamChoice;
  /** The stream that `auto` has chosen, and why. */
  streamWhy: string;
  readout: Readout;
  /** Revision that the server could not draw, until another picture arrives. */
  failedRevision: number | null;
  /** Missing parts of the picture, a sentence each. */
  lacking: string[];
  /** Visible layers that show nothing. */
  empty: EmptyLayer[];
  /** Layers that have places without a value to color by. */
  missing: string[];
  probe: Probe | null;
  /** The layer that was changed last. */
  touched: string | null;
  playing: boolean;
  playRate: number;
  loop: boolean;
  busy: string | null;
  helpOpen: boolean;
  panelOpen: boolean;
  theme: Theme;
  toasts: Toast[];
  /** CSS pixels. */
  canvasSize: Size;
  /** Boxes of the stage that overlays cover, except the box axes. */
  taken: Box[];
}

export const emptyReadout: Readout = {
  stream: "none",
  still: false,
  framesPerSecond: 0,
  latencyMs: null,
  roundTripMs: null,
  extractMs: 0,
  drawMs: 0,
  encodeMs: 0,
  triangles: 0,
  width: 0,
  height: 0,
  bytes: 0,
  time: 0,
  revision: 0,
  frame: 0,
};

export const initialState: PageState = {
  connection: { kind: "connecting", attempt: 0 },
  draining: false,
  refusal: null,
  fatal: null,
  server: null,
  datasets: null,
  description: null,
  describing: null,
  chosen: null,
  upcoming: null,
  shownDataset: null,
  shownScene: null,
  scene: null,
  seenFrom: null,
  shownFrom: null,
  canUndo: false,
  canRedo: false,
  pending: false,
  revision: 0,
  streamChoice: "auto",
  streamWhy: "",
  readout: emptyReadout,
  failedRevision: null,
  lacking: [],
  empty: [],
  missing: [],
  probe: null,
  touched: null,
  playing: false,
  playRate: 10,
  loop: true,
  busy: null,
  helpOpen: false,
  panelOpen: true,
  theme: "system",
  toasts: [],
  canvasSize: { width: 960, height: 640 },
  taken: [],
};
