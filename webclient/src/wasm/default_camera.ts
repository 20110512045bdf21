// The camera of a scene without a camera, computed by the code of server/annotations/camera.hpp.
import type { Camera } from "../generated/protocol";
import { call } from "./layout_module";
import type { ResultReader } from "./message";

const vector = (results: ResultReader): [number, number, number] => [
  results.number(),
  results.number(),
  results.number(),
];

/** `bounds`: lower and upper end along x, y and z. `aspect`: width / height. `fov`: degrees. */
export function defaultCamera(
  bounds: readonly [number, number, number, number, number, number],
  aspect: number,
  fov: number,
): Camera {
  const [x0, x1, y0, y1, z0, z1] = bounds;
  const results = call("default_camera", [x0, y0, z0, x1, y1, z1], aspect, fov);
  return {
    position: vector(results),
    target: vector(results),
    up: vector(results),
    parallel_height: results.number(),
    fov,
  };
}
