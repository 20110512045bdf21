// Members of the page's state. model.ts makes one signal for each member.
import type { ViewCamera, Size } from "./camera";
import type {
  CellExtremes,
  DatasetDescription,
  EmptyLayer,
  Methods,
  Notifications,
  ProbeResult,
  Range,
  Scene,
} from "../generated/protocol";
import type { Box } from "../wasm/overlay";

export type ConnectionState =
  | { kind: "connecting"; attempt: number }
  | { kind: "open" }
  | { kind: "waiting"; attempt: number; retryAt: number }
  | { kind: "closed" };

/** Reason why a server that answers HTTP does not open a WebSocket. */
export type Refusal =
  | { kind: "token" }
  /** Any other reason. `words`: text from the server or from a proxy. */
  | { kind: "refused"; words: string }
  /** HTTP calls are answered, so a proxy or firewall blocks WebSockets. */
  | { kind: "no-socket" };

export type StreamChoice = "image" | "jpeg" | "geometry" | "auto";
export type Theme = "system" | "dark" | "light";

export interface Readout {
  stream: "none" | "image" | "geometry";
  still: boolean;
  framesPerSecond: number;
  /** Milliseconds from the latest change until its picture was shown; null until measured. */
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
  /** Cells with the lowest and highest value. For an array interpolated from a cell array: cells of the cell array. */
  cells?: CellExtremes | undefined;
}

export interface LongCall {
  words: string;
  /** Name of the call in the notification call.progress. */
  name: string;
  progress: Notifications["call.progress"] | null;
}

export interface PageState {
  connection: ConnectionState;
  draining: boolean;
  refusal: Refusal | null;
  /** Sentence shown instead of the canvas when nothing can be drawn. */
  fatal: string | null;
  server: Methods["server.info"]["result"] | null;
  datasets: Methods["dataset.list"]["result"] | null;
  description: DatasetDescription | null;
  /** Name of the dataset whose description is being fetched. */
  describing: string | null;
  /** Name of the dataset that the user chose, until the scene uses it. */
  chosen: string | null;
  /** Description of the chosen dataset, until the scene uses this dataset. */
  upcoming: DatasetDescription | null;
  /** Scene of the shown picture, which may be older than `scene`. */
  shownScene: Scene | null;
  /** Newest scene, with changes that the server has not accepted yet. */
  scene: Scene | null;
  /** Camera that the server chose for a scene of `dataset` that has no camera. */
  seenFrom: { dataset: string; camera: ViewCamera } | null;
  canUndo: boolean;
  canRedo: boolean;
  /** Whether the server has not yet accepted the newest change. */
  pending: boolean;
  /** Revision of the newest change that the server has accepted. */
  revision: number;
  streamChoice: StreamChoice;
  /** For stream choice `auto`: the chosen stream and the reason, as a sentence. */
  streamWhy: string;
  readout: Readout;
  /** Revision that the server failed to draw. null after the next picture. */
  failedRevision: number | null;
  /** Sentences about data that the picture does not show. */
  lacking: string[];
  /** Visible layers without any geometry to show, with the reason. */
  empty: EmptyLayer[];
  /** Ids of layers that are colored by an array and have places without a value of this array. */
  missing: string[];
  probe: Probe | null;
  /** Id of the layer that was changed last. */
  touched: string | null;
  playing: boolean;
  playRate: number;
  loop: boolean;
  longCall: LongCall | null;
  helpOpen: boolean;
  panelOpen: boolean;
  theme: Theme;
  toasts: Toast[];
  /** Size of the canvas in CSS pixels. */
  canvasSize: Size;
  /** Boxes that title, captions and legends cover, in CSS pixels of the stage. */
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
  shownScene: null,
  scene: null,
  seenFrom: null,
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
  longCall: null,
  helpOpen: false,
  panelOpen: true,
  theme: "system",
  toasts: [],
  canvasSize: { width: 960, height: 640 },
  taken: [],
};
