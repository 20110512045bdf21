// What the page knows; model.ts makes a signal of each member.
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

/** Why a server that answers lets no socket through. */
export type Refusal =
  | { kind: "token" }
  /** Another reason, in the server's or a proxy's words. */
  | { kind: "refused"; words: string }
  /** Calls are answered, so something on the way holds WebSockets back. */
  | { kind: "no-socket" };

export type StreamChoice = "image" | "jpeg" | "geometry" | "auto";
export type Theme = "system" | "dark" | "light";

export interface Readout {
  stream: "none" | "image" | "geometry";
  still: boolean;
  framesPerSecond: number;
  /** From the hand's move to the picture of it. */
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
  /** Of the cells that the array is of or was made from. */
  cells?: CellExtremes | undefined;
}

export interface PageState {
  connection: ConnectionState;
  draining: boolean;
  /** Why a server that answers lets no socket through. */
  refusal: Refusal | null;
  /** A sentence that takes the canvas's place: nothing can be shown at all. */
  fatal: string | null;
  server: Methods["server.info"]["result"] | null;
  datasets: Methods["dataset.list"]["result"] | null;
  description: DatasetDescription | null;
  /** Whose description is on its way. */
  describing: string | null;
  /** A dataset that a hand has chosen, until the scene is of it. */
  chosen: string | null;
  /** The description of a chosen dataset, until the scene is of it. */
  upcoming: DatasetDescription | null;
  /** Whose picture stands there. */
  shownDataset: string | null;
  /** The scene of the picture that stands there, where that is known. */
  shownScene: Scene | null;
  scene: Scene | null;
  /** What the server takes for the camera that the scene of a dataset lacks. */
  seenFrom: { dataset: string; camera: FullCamera } | null;
  /** The camera of the picture that stands there; null where that is drawn here, by the newest. */
  shownFrom: FullCamera | null;
  canUndo: boolean;
  canRedo: boolean;
  /** The server has not taken the newest change yet. */
  pending: boolean;
  /** Of the newest change that the server has taken. */
  revision: number;
  streamChoice: StreamChoice;
  /** What `auto` has chosen, and why. */
  streamWhy: string;
  readout: Readout;
  /** Of the picture that the server could not draw, until another comes. */
  failedRevision: number | null;
  /** What the picture lacks, a sentence each. */
  lacking: string[];
  /** Layers that are switched on and of which nothing is seen. */
  empty: EmptyLayer[];
  /** Layers whose colors have places without a value. */
  missing: string[];
  probe: Probe | null;
  /** The layer that a hand has changed last. */
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
  /** Of the stage, by what stands over the canvas, but for the axes of the box. */
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
