// What a page shows first: the link's scene, else the tab's own session, else the first dataset that can be opened.
import type { DatasetDescription, Scene } from "../generated/protocol";
import { complete, distance, fit } from "../camera/camera";
import { subtract } from "../camera/vector";
import { RpcError } from "../protocol/rpc";
import type { Caller } from "../session/session";

export interface FirstSceneOptions {
  session: string;
  link: Scene | null;
  aspect: number;
  background: "dark" | "light";
}

/** The dataset's own first view, fitted to this canvas and theme. */
export function openingScene(description: DatasetDescription, aspect: number, background: "dark" | "light"): Scene {
  const scene = description.default_scene;
  const bounds = description.bounds;
  let camera = scene.camera ?? null;
  if (camera !== null && distance(complete(camera)) > 0) {
    const full = complete(camera);
    camera = fit(bounds, subtract(full.target, full.position), full.up, aspect, full.fov, full.parallel);
  }
  return { ...scene, camera, background };
}

/** null where the server offers nothing that can be opened. */
export async function firstScene(call: Caller, options: FirstSceneOptions): Promise<Scene | null> {
  if (options.link !== null) return options.link;
  try {
    return (await call("scene.get", { session: options.session })).scene;
  } catch (error) {
    if (!(error instanceof RpcError)) throw error; // the server does not know the session: a new one
  }
  const usable = (await call("dataset.list", {})).find(({ problem }) => problem === "");
  if (usable === undefined) return null;
  const description = await call("dataset.describe", { dataset: usable.name });
  return openingScene(description, options.aspect, options.background);
}
