// `auto`: pictures or polygons. Polygons answer a camera at once but cost their size at every change of a value.

export interface StreamFacts {
  current: "image" | "geometry";
  triangles: number;
  roundTripMs: number | null;
  /** WebGL2 by the graphics card. Software drawing here is no faster than on the server. */
  hardware: boolean;
}

/** Below this many triangles a frame of polygons is no larger than some pictures (26 bytes each). */
const FEW = 150_000;
/** Hysteresis: a scene that hovers at the border must not flip. */
const MANY = 300_000;
const SLOW_ROUND_TRIP_MS = 150;

export function chooseStream({ current, triangles, roundTripMs, hardware }: StreamFacts): "image" | "geometry" {
  if (!hardware) return "image";
  const far = (roundTripMs ?? 0) > SLOW_ROUND_TRIP_MS ? 2 : 1;
  const border = (current === "geometry" ? MANY : FEW) * far;
  return triangles <= border ? "geometry" : "image";
}

/** Asks the browser who draws its WebGL2. */
export function hasHardwareWebGL(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (gl === null) return false;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software|basic render/i.test(name);
}
