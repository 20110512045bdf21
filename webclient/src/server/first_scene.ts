// First scene of a page: the scene of the link, of the tab's session, or of the first usable dataset.
import type { Camera, DatasetDescription, Scene } from "../generated/protocol";
import { complete, defaultView, distance, fit, type Bounds, type ViewCamera } from "../model/camera";
import { subtract } from "../model/vector";
import { RpcError } from "./rpc";
import { legendsOf } from "../model/scalars";
import type { Caller } from "./session";
import type { CanvasSize } from "../model/canvas_size";

export interface FirstSceneOptions {
  session: string;
  /** Whether the session id comes from the tab or from the link. The session may then exist on the server. */
  rejoin: boolean;
  link: Scene | null;
  size: CanvasSize;
  background: "dark" | "light";
}

function openingCamera(camera: Camera | null | undefined, bounds: Bounds, aspect: number): ViewCamera {
  if (!camera || distance(complete(camera)) === 0) return defaultView(bounds, aspect);
  const { position, target, up, fov, parallel } = complete(camera);
  return fit(bounds, subtract(target, position), up, aspect, fov, parallel);
}

export function openingScene(description: DatasetDescription, size: CanvasSize, background: "dark" | "light"): Scene {
  const scene = description.default_scene;
  const bounds = description.default_bounds;
  const camera = size.clearOfCorner(openingCamera(scene.camera, bounds, size.aspect), bounds);
  return { ...scene, camera, background };
}

/** Adds a camera if the scene has none, because overlays of the canvas need one. */
async function withCamera(call: Caller, scene: Scene, size: CanvasSize): Promise<Scene> {
  if (scene.camera) return scene;
  try {
    const description = await call("dataset.describe", { dataset: scene.dataset });
    if (scene.annotations?.legend !== false) size.expectLegends(legendsOf(scene, description).length);
    const { bounds } = description;
    return { ...scene, camera: size.clearOfCorner(defaultView(bounds, size.aspect), bounds) };
  } catch (error) {
    if (!(error instanceof RpcError)) throw error;
    return scene; // session.open will report the error for this scene
  }
}

/** Returns null if the server has no usable dataset. */
export async function firstScene(call: Caller, options: FirstSceneOptions): Promise<Scene | null> {
  if (options.link !== null) return withCamera(call, options.link, options.size);
  try {
    if (options.rejoin) return (await call("scene.get", { session: options.session })).scene;
  } catch (error) {
    if (!(error instanceof RpcError)) throw error; // an RpcError means that the server does not know the session
  }
  const usable = (await call("dataset.list", {})).find(({ problem }) => problem === "");
  if (usable === undefined) return null;
  const description = await call("dataset.describe", { dataset: usable.name });
  return openingScene(description, options.size, options.background);
}
