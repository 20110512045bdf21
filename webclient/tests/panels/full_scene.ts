// A scene with a layer of each type, for tests that need all panels at work.
import type { Scene } from "../../src/generated/protocol";

const threshold = { array: "p", range: [2, 8] as [number, number] };
const color = { array: "p", range: [0, 10] as [number, number] };
const points = [
  { at: 0, color: "#000000" },
  { at: 0.5, color: "#ff0000" },
  { at: 1, color: "#ffffff" },
];

export const fullScene: Scene = {
  dataset: "box",
  time: 0,
  camera: { position: [0, -9, 0], target: [0, 0, 0], up: [0, 0, 1] },
  background: "#102030",
  annotations: { axes: true, title: "Box", dataset: true, time: true },
  lighting: { ambient_occlusion: { on: true } },
  layers: {
    iso: { type: "iso", array: "p", values: [2, 4], order: 0, color, edges: {} },
    cut: {
      type: "slice",
      axis: "z",
      value: 0.5,
      order: 1,
      color: { array: "T", range: [200, 400] },
      contours: { array: "T", values: [250, 300], coloring: { map: "inferno" } },
    },
    free: { type: "slice", origin: [0.5, 0.5, 0.5], normal: [1, 1, 0], order: 2, contours: { array: "p" } },
    wall: { type: "surface", order: 3, threshold },
    inlet: { type: "surface", groups: ["inlet"], order: 4 },
    edges: { type: "edges", angle: 30, order: 5, threshold },
    points: { type: "points", order: 6 },
    clip: { type: "clip", axis: "x", value: 0.5, order: 7, color: { ...color, points } },
    fog: { type: "volume", array: "p", order: 8 },
    outline: { type: "outline", order: 9 },
  },
};
