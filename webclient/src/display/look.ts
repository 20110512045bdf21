// How the geometry is looked at.
import type { Bounds, FullCamera } from "../camera/camera";
import type { Rgb } from "./background";
import type { Lights } from "./lights";

export interface Look {
  camera: FullCamera;
  bounds: Bounds;
  backgroundTop: Rgb;
  backgroundBottom: Rgb;
  lights: Lights;
}
