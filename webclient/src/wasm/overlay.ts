// The layout of axes and triad over the canvas, by server/annotations/layout.hpp. Coordinates are CSS pixels from the
// upper left corner of the stage.
import { call } from "./layout_module";
import type { ResultReader } from "./message";

export interface Place {
  x: number;
  y: number;
}
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
/** CSS color. */
export type Ink = string;

/** Background behind a text. It fades out over `edge` pixels around the box. */
export interface Plate {
  box: Box;
  edge: number;
  ink: Ink;
}
export interface Stroke {
  from: Place;
  to: Place;
  width: number;
  ink: Ink;
}
export interface Triangle {
  corners: [Place, Place, Place];
  ink: Ink;
}
export interface Label {
  text: string;
  /** Font size. */
  pixels: number;
  /** Start of the base line. */
  at: Place;
  ink: Ink;
  box: Box;
}

/** A flat drawing, painted in this order. */
export interface Overlay {
  plates: Plate[];
  strokes: Stroke[];
  triangles: Triangle[];
  labels: Label[];
  /** Color around letters, for any background. */
  halo: Ink;
}

export interface Annotations {
  triad: Overlay;
  axes: Overlay;
}

type Numbers = readonly number[];

export interface AnnotatedView {
  size: { width: number; height: number };
  /** Text size in CSS pixels. */
  text: number;
  camera: {
    position: Numbers;
    target: Numbers;
    up: Numbers;
    fov: number;
    parallel: boolean;
    parallel_height: number;
  };
  /** Low and high along x, y and z. */
  bounds: readonly [number, number, number, number, number, number];
  /** RGB from 0 to 1 at the top and the bottom. */
  background: { top: Numbers; bottom: Numbers };
  triad: boolean;
  axes: boolean;
  lengthUnits: string;
  /** Boxes that other overlays cover. */
  taken: readonly Box[];
}

function ink(results: ResultReader): Ink {
  const channel = (): number => Math.round(255 * results.number());
  return `rgb(${channel()} ${channel()} ${channel()} / ${results.number()})`;
}

const place = (results: ResultReader): Place => ({ x: results.number(), y: results.number() });

const box = (results: ResultReader): Box => ({
  left: results.number(),
  top: results.number(),
  right: results.number(),
  bottom: results.number(),
});

function overlay(results: ResultReader): Overlay {
  return {
    plates: results.list(() => ({ box: box(results), edge: results.number(), ink: ink(results) })),
    strokes: results.list(() => ({
      from: place(results),
      to: place(results),
      width: results.number(),
      ink: ink(results),
    })),
    triangles: results.list(() => ({ corners: [place(results), place(results), place(results)], ink: ink(results) })),
    labels: results.list(() => ({
      text: results.text(),
      pixels: results.number(),
      at: place(results),
      ink: ink(results),
      box: box(results),
    })),
    halo: ink(results),
  };
}

export function layOut(view: AnnotatedView): Annotations {
  const { size, camera, bounds, background, taken } = view;
  const results = call(
    "lay_out",
    [Math.round(size.width), Math.round(size.height), view.text],
    [camera.position, camera.target, camera.up, camera.fov, camera.parallel, camera.parallel_height],
    [bounds[0], bounds[2], bounds[4], bounds[1], bounds[3], bounds[5]],
    [background.top, background.bottom],
    [view.triad, view.axes, view.lengthUnits],
    [taken.length, taken.map(({ left, top, right, bottom }) => [left, top, right, bottom])],
  );
  return { triad: overlay(results), axes: overlay(results) };
}
