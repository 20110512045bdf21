// Chooses the stream, pictures or polygons, by the time that a change needs. A pure function of measured values.

export type Kind = "image" | "geometry";
/** "camera": the camera moves, which needs no new polygons. "value": anything else changes. "rest": nothing changes. */
export type Gesture = "camera" | "value" | "rest";

export interface StreamFacts {
  current: Kind;
  gesture: Gesture;
  /** Measured bytes per second of the connection; null until a frame was long enough to measure. */
  lineRate: number | null;
  /** Whether a still picture has arrived. If so and `lineRate` is null, the picture was too short to measure. */
  sawStill: boolean;
  /** Round trip of a call in milliseconds; null until a call has been answered. */
  roundTripMs: number | null;
  /** Bytes of an interactive picture. `pictureMs`: its server time in milliseconds, including extraction. */
  pictureBytes: number;
  pictureMs: number;
  /** Bytes of all polygons of the scene. After a switch from pictures, the server sends all polygons. */
  polygonBytes: number;
  /** Bytes of the new polygons after a change of a value. `extractMs`: extraction time in milliseconds. */
  changeBytes: number;
  extractMs: number;
  /** Milliseconds from request to drawn polygons in this browser; null if not measured. */
  drawMs: number | null;
  /** Whether WebGL2 uses the graphics card. */
  hardware: boolean;
  /** Name of a feature of the scene that only pictures can show; empty if there is none. */
  onlyPictures: string;
}

export interface Choice {
  stream: Kind;
  why: string;
}

/** Draw time of polygons in milliseconds that is assumed until the first measurement. Valid with a graphics card. */
const USUAL_DRAW_MS = 16;
/** Draw time of polygons in milliseconds above which pictures are used, if a picture arrives sooner. */
const TOO_SLOW_MS = 100;
/** During a value gesture, only a stream that is faster by this factor is chosen, which prevents repeated switching. */
const BETTER = 1.3;
/** Longest accepted transfer of all polygons, in seconds: without a gesture, and during a camera gesture. */
const FETCH_AT_REST = 3;
const FETCH_IN_GESTURE = 0.3;

/** Until a rate is measured, NEAR_RATE in bytes per second is assumed for round trips of at most NEAR_MS. */
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
      `this browser needs ${seconds(draw / 1000)} to draw the polygons, a picture arrives in ${seconds(picture)}`,
    );
  const line = `${amount(lineRate)}/s`;
  if (facts.gesture === "value") {
    const bytes = current === "geometry" ? facts.changeBytes : polygonBytes;
    const change = Math.max(facts.extractMs / 1000, bytes / lineRate) + draw / 1000;
    const compared = `a change takes ${seconds(change)} with polygons (${amount(bytes)} at ${line}) and ${seconds(picture)} with pictures`;
    const border = current === "geometry" ? picture * BETTER : picture / BETTER;
    return change <= border ? { stream: "geometry", why: compared } : pictures(compared);
  }
  if (current === "geometry") return { stream: "geometry", why: "the view turns without a picture from the server" };
  const patience = facts.gesture === "rest" ? FETCH_AT_REST : FETCH_IN_GESTURE;
  const cost = `the polygons (${amount(polygonBytes)}) arrive in ${seconds(fetch)} at ${line}`;
  return fetch <= patience
    ? { stream: "geometry", why: `${cost}, and the view turns without the server` }
    : pictures(cost);
}

/**
 * Chooses the stream while the line rate is unknown. Does not switch to polygons during a value gesture, because each
 * change makes new polygons.
 */
function unmeasured({ current, gesture, sawStill, polygonBytes, pictureBytes }: StreamFacts): Choice {
  const isFewer = sawStill && polygonBytes <= pictureBytes;
  if (isFewer && (gesture !== "value" || current === "geometry"))
    return {
      stream: "geometry",
      why: `the polygons are ${amount(polygonBytes)}, a picture is ${amount(pictureBytes)}`,
    };
  return { stream: current, why: "the speed of the connection is not measured yet" };
}

const pictures = (why: string): Choice => ({ stream: "image", why });

export function hasHardwareWebGL(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (gl === null) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software|basic render/i.test(name);
}
