// Camera, bounding box, background and lights of a picture of polygons.
import type { Bounds, ViewCamera } from "../model/camera";
import type { Rgb } from "../wasm/background";
import type { Lights } from "../model/lights";

export interface Look {
  camera: ViewCamera;
  bounds: Bounds;
  backgroundTop: Rgb;
  backgroundBottom: Rgb;
  lights: Lights;
}
