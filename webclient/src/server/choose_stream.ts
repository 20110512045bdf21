// Automatic choice of pictures or polygons by the cost of a change. A pure function of measured facts.

export type Kind = "image" | "geometry";
/** What the user changes: the camera (needs no new polygons), a value (does), or nothing. */
export type Gesture = "camera" | "value" | "rest";

export interface StreamFacts {
  current: Kind;
  gesture: Gesture;
  /** Bytes per second; null until a long frame has arrived. */
  lineRate: number | null;
  /** A still has arrived. If long enough, it has measured the line. */
  sawStill: boolean;
  /** Round trip of a call; null until one was answered. */
  roundTripMs: number | null;
  /** Bytes of an interactive picture. `pictureMs`: server time including extraction. */
  pictureBytes: number;
  pictureMs: number;
  /** Bytes of all polygons of the scene. `extractMs`: server time for them. */
  polygonBytes: number;
  extractMs: number;
  /** Time from request to drawn polygons in this browser; null if not measured. */
  drawMs: number | null;
  /** WebGL2 uses the graphics card. */
  hardware: boolean;
  /** Name of a feature that only pictures can show; empty: none. */
  onlyPictures: string;
}

export interface Choice {
  stream: Kind;
  /** Reason, for the user. */
  why: string;
}

/** Assumed draw time with a graphics card before any measurement. */
const USUAL_DRAW_MS = 16;
/** Polygons that take longer to draw are used only if pictures are slower still. */
const TOO_SLOW_MS = 100;
/** Hysteresis: the stream changes only for one that is faster by this factor. */
const BETTER = 1.3;
/** Seconds that polygons may take to arrive at rest, and during a camera gesture. */
const FETCH_AT_REST = 3;
const FETCH_IN_GESTURE = 0.3;

/** Assumed line rate for a round trip up to NEAR_MS, if all frames were too short to measure. */
const NEAR_MS = 25;
const NEAR_RATE = 12.5e6;

function amount(bytes: number): string {
  if (bytes < 1e5) return `${(bytes / 1e3).toFixed(bytes < 1e4 ? 1 : 0)} kB`;
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0)} MB`;
}
const seconds = (value: number): string => `${value < 1 ? value.toFixed(2) : value.toFixed(1)} s`;

export function chooseStream(facts: StreamFacts): Choice {
  const { current, hardware, drawMs, roundTripMs, polygonBytes } = facts;
  const isNear = facts.sawStill && roundTripMs !== null && roundTripMs <= NEAR_MS;
  const lineRate = facts.lineRate ?? (isNear ? NEAR_RATE : null);
  if (facts.onlyPictures !== "") return pictures(`${facts.onlyPictures} is shown in pictures only`);
  if (!hardware) return pictures("this browser draws without a graphics card");
  if (lineRate === null) return unmeasured(facts);
  const draw = drawMs ?? USUAL_DRAW_MS;
  const fetch = polygonBytes / lineRate;
  const picture = Math.max(facts.pictureMs / 1000, facts.pictureBytes / lineRate);
  if (draw > TOO_SLOW_MS && draw / 1000 > picture)
    return pictures(
      `this browser needs ${seconds(draw / 1000)} to draw the polygons, a picture comes in ${seconds(picture)}`,
    );
  const line = `${amount(lineRate)}/s`;
  if (facts.gesture === "value") {
    const change = Math.max(facts.extractMs / 1000, fetch) + draw / 1000;
    const compared = `a change is ${seconds(change)} of polygons (${amount(polygonBytes)} at ${line}) and ${seconds(picture)} of pictures`;
    const border = current === "geometry" ? picture * BETTER : picture / BETTER;
    return change <= border ? { stream: "geometry", why: compared } : pictures(compared);
  }
  if (current === "geometry") return { stream: "geometry", why: "the view turns without a picture from the server" };
  const patience = facts.gesture === "rest" ? FETCH_AT_REST : FETCH_IN_GESTURE;
  const cost = `the polygons (${amount(polygonBytes)}) come in ${seconds(fetch)} at ${line}`;
  return fetch <= patience
    ? { stream: "geometry", why: `${cost}, and the view turns without the server` }
    : pictures(cost);
}

/** Polygons not larger than a picture suit any line, except when every change makes new ones. */
function unmeasured({ current, gesture, sawStill, polygonBytes, pictureBytes }: StreamFacts): Choice {
  const isFewer = sawStill && polygonBytes <= pictureBytes;
  if (isFewer && (gesture !== "value" || current === "geometry"))
    return {
      stream: "geometry",
      why: `the polygons are ${amount(polygonBytes)}, a picture is ${amount(pictureBytes)}`,
    };
  return { stream: current, why: "the line is not measured yet" };
}

const pictures = (why: string): Choice => ({ stream: "image", why });

/** Whether the browser's WebGL2 renderer is not a software renderer. */
export function hasHardwareWebGL(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (gl === null) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software|basic render/i.test(name);
}
