// View and projection matrices of a camera for WebGL, and its near and far planes.
import { boundsCenter, boundsRadius, frame, type Bounds, type ViewCamera } from "../model/camera";
import { dot, subtract, type Matrix, type Vec3 } from "../model/vector";

/** Returns the matrix for positions relative to `origin`, because 32-bit world coordinates would lose digits. */
export function viewMatrix(camera: ViewCamera, origin: Vec3): Matrix {
  const { right: r, up: u, forward: f } = frame(camera);
  const eye = subtract(camera.position, origin);
  return [r[0], u[0], -f[0], 0, r[1], u[1], -f[1], 0, r[2], u[2], -f[2], 0, -dot(r, eye), -dot(u, eye), dot(f, eye), 1];
}

/** Returns the distances of the near and far planes. They are close to the bounding box for a high depth resolution. */
export function depthRange(camera: ViewCamera, bounds: Bounds): [number, number] {
  const radius = Math.max(boundsRadius(bounds), 1e-12) * 1.01;
  const along = dot(subtract(boundsCenter(bounds), camera.position), frame(camera).forward);
  if (camera.parallel) return [along - radius, along + radius];
  const far = Math.max(along + radius, radius * 1e-3);
  return [Math.max(along - radius, far * 1e-4), far];
}

export function projectionMatrix(camera: ViewCamera, aspect: number, [near, far]: [number, number]): Matrix {
  if (camera.parallel) {
    const y = 2 / camera.parallel_height;
    return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, -2 / (far - near), 0, 0, 0, -(far + near) / (far - near), 1];
  }
  const y = 1 / Math.tan((camera.fov * Math.PI) / 360);
  const z = (near + far) / (near - far);
  return [y / aspect, 0, 0, 0, 0, y, 0, 0, 0, 0, z, -1, 0, 0, (2 * near * far) / (near - far), 0];
}
