// Camera operations as pure functions. Pixel coordinates are relative to the canvas, with y downwards.
import { DEFAULTS, type Camera } from "../generated/protocol";
import { defaultCamera } from "../wasm/default_camera";
import { add, cross, dot, length, normalize, rotate, scale, subtract, type Vec3 } from "./vector";

export type Bounds = [number, number, number, number, number, number];
export interface Size {
  width: number;
  height: number;
}
/** A camera with all defaults filled in. `up` is perpendicular to the view direction. */
export type ViewCamera = Required<Camera>;

export const DEFAULT_FOV = DEFAULTS.Camera.fov;
/** Limits of the field-of-view controls in degrees. A scene may exceed these limits. */
export const FOV_RANGE: readonly [number, number] = [1, 120];
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

export function complete(camera: Camera): ViewCamera {
  const fov = camera.fov ?? DEFAULT_FOV;
  const distance = length(subtract(camera.position, camera.target));
  const height = camera.parallel_height ?? 2 * distance * Math.tan(radians(fov) / 2);
  const { parallel, up } = DEFAULTS.Camera;
  const full = { fov, parallel: camera.parallel ?? parallel, parallel_height: height || 1, up: camera.up ?? up };
  const result: ViewCamera = { ...full, position: camera.position, target: camera.target };
  return { ...result, up: frame(result).up };
}

export interface Axes {
  right: Vec3;
  up: Vec3;
  forward: Vec3;
}

/** Returns the camera's axes as unit vectors. If `up` is parallel to the view direction, chooses another `up`. */
export function frame(camera: ViewCamera): Axes {
  const forward = normalize(subtract(camera.target, camera.position), [0, 1, 0]);
  let right = cross(forward, camera.up);
  if (length(right) < 1e-9 * Math.max(1, length(camera.up))) {
    right = cross(forward, Math.abs(forward[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0]);
  }
  right = normalize(right);
  return { right, up: cross(right, forward), forward };
}

export const distance = (camera: ViewCamera): number => length(subtract(camera.target, camera.position));

/** Height of the visible area at the target's depth, in length units. */
export function viewHeight(camera: ViewCamera): number {
  return camera.parallel ? camera.parallel_height : 2 * distance(camera) * Math.tan(radians(camera.fov) / 2);
}

/**
 * Rotates the camera about `pivot` for a drag of (dx, dy) pixels. A drag as long as the shorter side of the canvas is
 * half a turn. The pivot keeps its pixel.
 */
export function orbit(camera: ViewCamera, dx: number, dy: number, size: Size, pivot: Vec3 = camera.target): ViewCamera {
  const perPixel = Math.PI / Math.max(1, Math.min(size.width, size.height));
  const { right, up } = frame(camera);
  const turnedRight = rotate(right, up, -dx * perPixel);
  const turned = (arm: Vec3): Vec3 => rotate(rotate(arm, up, -dx * perPixel), turnedRight, -dy * perPixel);
  const about = (point: Vec3): Vec3 => add(pivot, turned(subtract(point, pivot)));
  return { ...camera, position: about(camera.position), target: about(camera.target), up: turned(up) };
}

/** Rotates the camera about the view direction by `angle` radians. */
export function roll(camera: ViewCamera, angle: number): ViewCamera {
  const { forward, up } = frame(camera);
  return { ...camera, up: rotate(up, forward, angle) };
}

/** Moves the camera so that points at the target's depth follow a drag of (dx, dy) pixels. */
export function pan(camera: ViewCamera, dx: number, dy: number, size: Size): ViewCamera {
  const perPixel = viewHeight(camera) / Math.max(1, size.height);
  const { right, up } = frame(camera);
  const shift = add(scale(right, -dx * perPixel), scale(up, dy * perPixel));
  return { ...camera, position: add(camera.position, shift), target: add(camera.target, shift) };
}

/** A factor below 1 moves the camera closer. The point at pixel (x, y) and at the target's depth keeps its pixel. */
export function zoom(camera: ViewCamera, factor: number, x: number, y: number, size: Size): ViewCamera {
  const offsetX = x - size.width / 2;
  const offsetY = y - size.height / 2;
  const towards = pan(camera, -offsetX, -offsetY, size); // the target is now the point under the cursor
  const arm = scale(subtract(towards.position, towards.target), factor);
  const closer = { ...towards, position: add(towards.target, arm), parallel_height: camera.parallel_height * factor };
  return pan(closer, offsetX, offsetY, size);
}

/** Limits of the distance to the target (parallel view: of the view height), as multiples of the bounds' diagonal. */
export const REACH: readonly [number, number] = [1e-6, 1e4];

/** Returns `factor`, clamped so that the camera stays in REACH. A camera outside REACH can only move towards REACH. */
export function withinReach(camera: ViewCamera, factor: number, bounds: Bounds): number {
  const away = camera.parallel ? camera.parallel_height : distance(camera);
  const [nearest, furthest] = REACH.map((reach) => (reach * (2 * boundsRadius(bounds) || 1)) / away) as [
    number,
    number,
  ];
  const allowed = Math.min(Math.max(factor, Math.min(1, nearest)), Math.max(1, furthest));
  return Math.abs(allowed - 1) < 1e-6 ? 1 : allowed; // at a limit of REACH, such a factor is only a rounding error
}

export function center(camera: ViewCamera, point: Vec3): ViewCamera {
  return { ...camera, position: add(camera.position, subtract(point, camera.target)), target: point };
}

/** The view height at the target stays the same. */
export function withParallel(camera: ViewCamera, parallel: boolean): ViewCamera {
  if (parallel === camera.parallel) return camera;
  if (parallel) return { ...camera, parallel, parallel_height: viewHeight(camera) };
  const away = camera.parallel_height / (2 * Math.tan(radians(camera.fov) / 2));
  const arm = scale(normalize(subtract(camera.position, camera.target)), away);
  return { ...camera, parallel, position: add(camera.target, arm) };
}

/** `fov` is in degrees. The view height at the target stays the same. */
export function withFieldOfView(camera: ViewCamera, fov: number): ViewCamera {
  const away = viewHeight(camera) / (2 * Math.tan(radians(fov) / 2));
  const arm = scale(normalize(subtract(camera.position, camera.target)), away);
  return { ...camera, fov, position: add(camera.target, arm) };
}

/** `height`: see viewHeight(). A perspective camera changes its distance from the target, not its field of view. */
export function withViewHeight(camera: ViewCamera, height: number): ViewCamera {
  if (camera.parallel) return { ...camera, parallel_height: height };
  const arm = scale(subtract(camera.position, camera.target), height / viewHeight(camera));
  return { ...camera, position: add(camera.target, arm) };
}

export const boundsCenter = (b: Bounds): Vec3 => [(b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2];
export const boundsRadius = (b: Bounds): number => Math.hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]) / 2;

export function corners(b: Bounds): Vec3[] {
  const ends = (low: number, high: number): number[] => [low, high];
  return ends(b[0], b[1]).flatMap((x) => ends(b[2], b[3]).flatMap((y) => ends(b[4], b[5]).map((z): Vec3 => [x, y, z])));
}

const MARGIN = 1.06;

/** Returns a camera that looks along `forward` at the center of the box and shows the whole box. */
export function fit(
  bounds: Bounds,
  forward: Vec3,
  up: Vec3,
  aspect: number,
  fov = DEFAULT_FOV,
  parallel = false,
): ViewCamera {
  const target = boundsCenter(bounds);
  const start = { position: subtract(target, forward), target, up, fov, parallel, parallel_height: 1 };
  const axes = frame(start);
  const tan = Math.tan(radians(fov) / 2);
  let away = 0;
  let height = 0;
  for (const corner of corners(bounds)) {
    const arm = subtract(corner, target);
    const half = Math.max(Math.abs(dot(arm, axes.up)), Math.abs(dot(arm, axes.right)) / aspect);
    away = Math.max(away, (half * MARGIN) / tan - dot(arm, axes.forward));
    height = Math.max(height, 2 * half * MARGIN);
  }
  if (away <= 0) away = 1;
  return { ...start, up: axes.up, position: subtract(target, scale(axes.forward, away)), parallel_height: height || 1 };
}

export type AxisView = "+x" | "-x" | "+y" | "-y" | "+z" | "-z";
export const AXIS_VIEWS: readonly AxisView[] = ["+x", "-x", "+y", "-y", "+z", "-z"];

/** Returns a view of the box along an axis. "+x" is a view from the positive x side of the box. */
export function axisView(side: AxisView, bounds: Bounds, aspect: number, fov: number, parallel: boolean): ViewCamera {
  const sign = side.startsWith("+") ? -1 : 1;
  const forward: Vec3 = [0, 0, 0];
  const axis = "xyz".indexOf(side.charAt(1)) as 0 | 1 | 2;
  forward[axis] = sign;
  return fit(bounds, forward, axis === 2 ? [0, 1, 0] : [0, 0, 1], aspect, fov, parallel);
}

/**
 * Returns a view of the whole box from the side of larger x, smaller y and larger z. The server's default view has the
 * same direction, and also leaves room for annotations.
 */
export function defaultView(bounds: Bounds, aspect: number, fov = DEFAULT_FOV, parallel = false): ViewCamera {
  return complete({ ...defaultCamera(bounds, aspect, fov), parallel });
}

const EDGE_SAMPLES = 24;
const BACK = 1.03;
/** Largest zoom factor of clearOf(). If a larger factor is needed, clearOf() returns the camera unchanged. */
const FURTHEST = 1.6;

function edgePoints(bounds: Bounds): Vec3[] {
  const ends = corners(bounds); // the bits of an index are x, y, z: adjacent corners differ in one bit
  const pairs = ends.flatMap((_, i) => [1, 2, 4].filter((bit) => (i & bit) === 0).map((bit) => [i, i | bit] as const));
  const at = (i: number): Vec3 => ends[i] ?? [0, 0, 0];
  return pairs.flatMap(([i, j]) =>
    Array.from({ length: EDGE_SAMPLES + 1 }, (_, k) => add(at(i), scale(subtract(at(j), at(i)), k / EDGE_SAMPLES))),
  );
}

/**
 * Returns the camera, moved back until no edge of the box lies behind a legend. `taken`: sizes of rectangles at the top
 * right corner of the canvas.
 */
export function clearOf(camera: ViewCamera, bounds: Bounds, size: Size, ...taken: Size[]): ViewCamera {
  const points = edgePoints(bounds);
  const covered = (view: ViewCamera): boolean =>
    points.some((point) => {
      const place = project(view, point, size);
      if (place === null) return false;
      return taken.some(({ width, height }) => place.x > size.width - width && place.y < height);
    });
  let view = camera;
  for (let away = 1; covered(view); away *= BACK) {
    if (away > FURTHEST) return camera;
    view = zoom(view, BACK, size.width / 2, size.height / 2, size);
  }
  return view;
}

/**
 * Returns the pixel of a point, and its distance from the camera along the view direction. Returns null for a point
 * that is not in front of a perspective camera.
 */
export function project(camera: ViewCamera, point: Vec3, size: Size): { x: number; y: number; depth: number } | null {
  const { right, up, forward } = frame(camera);
  const arm = subtract(point, camera.position);
  const depth = dot(arm, forward);
  if (!camera.parallel && depth <= 0) return null;
  const height = camera.parallel ? camera.parallel_height : 2 * depth * Math.tan(radians(camera.fov) / 2);
  const perUnit = size.height / height;
  return { x: size.width / 2 + dot(arm, right) * perUnit, y: size.height / 2 - dot(arm, up) * perUnit, depth };
}
