// Automatic: pictures or polygons, by what a change costs as each. A function of what is known.

export type Kind = "image" | "geometry";
/** What the hand moves: the camera, which needs no new polygons; anything else, which does; or nothing. */
export type Gesture = "camera" | "value" | "rest";

export interface StreamFacts {
  current: Kind;
  gesture: Gesture;
  /** Bytes a second; null where no long frame has come yet. */
  lineRate: number | null;
  /** A still has come: it measures the line wherever it is long enough. */
  sawStill: boolean;
  /** Of a call; null where none has been answered. */
  roundTripMs: number | null;
  /** Of an interactive picture; `pictureMs`: the server's time for it, the extraction included. */
  pictureBytes: number;
  pictureMs: number;
  /** Of all polygons of the scene; `extractMs`: the server's time for them. */
  polygonBytes: number;
  extractMs: number;
  /** From the wish to the drawing of polygons here; null where it has not been seen. */
  drawMs: number | null;
  /** WebGL2 by the graphics card. */
  hardware: boolean;
  /** What only pictures show, in words; empty: nothing. */
  onlyPictures: string;
}

export interface Choice {
  stream: Kind;
  /** For a person. */
  why: string;
}

/** A drawing that has not been seen, by a graphics card. */
const USUAL_DRAW_MS = 16;
/** As slow as nobody wants to turn things, however slow pictures are. */
const TOO_SLOW_MS = 100;
/** A stream is left for one that is so much quicker: a scene at the border must not flip. */
const BETTER = 1.3;
/** Seconds that polygons may take to come while the hand holds still, and while it turns the view. */
const FETCH_AT_REST = 3;
const FETCH_IN_GESTURE = 0.3;

/** A server this near is reached by a fast line: what is known of it where all frames were too short to measure. */
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

/** Polygons of no more bytes than a picture are right on any line, unless they are made for every change. */
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

/** Asks the browser who draws its WebGL2. */
export function hasHardwareWebGL(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (gl === null) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software|basic render/i.test(name);
}
