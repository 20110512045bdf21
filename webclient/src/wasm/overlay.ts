// Layout of annotations by the code of server/annotations/layout.hpp, in CSS pixels from the stage's upper left.
import { scaleItem, type ScaleInBytes } from "./color_scale";
import { call } from "./layout_module";
import type { Item, ResultReader } from "./message";

export interface PicturePoint {
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

/** Background behind a text. The plate extends `edge` pixels beyond the box on each side. */
export interface Plate {
  box: Box;
  edge: number;
  ink: Ink;
}
/** A vertical gradient. */
export interface Fill {
  box: Box;
  top: Ink;
  bottom: Ink;
}
export interface Stroke {
  from: PicturePoint;
  to: PicturePoint;
  width: number;
  ink: Ink;
}
export interface Triangle {
  corners: [PicturePoint, PicturePoint, PicturePoint];
  ink: Ink;
}
export interface Label {
  text: string;
  /** Font size. */
  pixels: number;
  /** Start of the base line. */
  at: PicturePoint;
  ink: Ink;
  box: Box;
}

/** Box over which the page places a field or buttons. `id` names the content of the box, such as "legend 0 low". */
export interface Handle {
  id: string;
  box: Box;
}

/** A two-dimensional drawing. The members are painted in their order here. */
export interface Overlay {
  plates: Plate[];
  fills: Fill[];
  strokes: Stroke[];
  triangles: Triangle[];
  labels: Label[];
  handles: Handle[];
  /** Color around letters, which keeps text readable on any background. */
  halo: Ink;
}

export interface Annotations {
  triad: Overlay;
  axes: Overlay;
}

type Numbers = readonly number[];

interface Picture {
  size: { width: number; height: number };
  /** Text size in CSS pixels. */
  text: number;
  /** Colors at the top and the bottom, as RGB from 0 to 1. */
  background: { top: Numbers; bottom: Numbers };
}

export interface AnnotatedView extends Picture {
  camera: {
    position: Numbers;
    target: Numbers;
    up: Numbers;
    fov: number;
    parallel: boolean;
    parallel_height: number;
  };
  /** Lowest and highest coordinate along x, y and z. */
  bounds: readonly [number, number, number, number, number, number];
  triad: boolean;
  axes: boolean;
  lengthUnits: string;
  taken: readonly Box[];
}

function ink(results: ResultReader): Ink {
  const channel = (): number => Math.round(255 * results.number());
  return `rgb(${channel()} ${channel()} ${channel()} / ${results.number()})`;
}

const picturePoint = (results: ResultReader): PicturePoint => ({ x: results.number(), y: results.number() });

const box = (results: ResultReader): Box => ({
  left: results.number(),
  top: results.number(),
  right: results.number(),
  bottom: results.number(),
});

function overlay(results: ResultReader): Overlay {
  return {
    plates: results.list(() => ({ box: box(results), edge: results.number(), ink: ink(results) })),
    fills: results.list(() => ({ box: box(results), top: ink(results), bottom: ink(results) })),
    strokes: results.list(() => ({
      from: picturePoint(results),
      to: picturePoint(results),
      width: results.number(),
      ink: ink(results),
    })),
    triangles: results.list(() => ({
      corners: [picturePoint(results), picturePoint(results), picturePoint(results)],
      ink: ink(results),
    })),
    labels: results.list(() => ({
      text: results.text(),
      pixels: results.number(),
      at: picturePoint(results),
      ink: ink(results),
      box: box(results),
    })),
    handles: results.list(() => ({ id: results.text(), box: box(results) })),
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

export interface LegendText {
  array: string;
  units: string;
  scale: ScaleInBytes;
  /** Name of the layers that use the scale. Empty if the array has only one legend. */
  layers: string;
  /** Whether places of the colored layers have no value. The legend then shows the color of missing values. */
  missing: boolean;
  /** Whether both ends have a number even if the range has no width. Otherwise such a range has one number. */
  bothEnds: boolean;
  /** More lines below `layers`. */
  lines: readonly string[];
  /** Space in CSS pixels that is kept free for controls below the bar. */
  controls: { width: number; height: number };
}

export interface AnnotatedTexts extends Picture {
  title: string;
  captions: readonly string[];
  legends: readonly LegendText[];
}

export interface Texts {
  overlay: Overlay;
  taken: Box[];
}

const listed = <T>(items: readonly T[], itemOf: (item: T) => Item): Item => [items.length, items.map(itemOf)];

const legendItem = ({ array, units, scale, layers, missing, bothEnds, lines, controls }: LegendText): Item => [
  [array, units, scaleItem(scale)],
  [layers, missing, bothEnds, listed(lines, (line) => line), controls.width, controls.height],
];

/** Lays out title, captions and legends. A legend that does not fit is left out and has no handles. */
export function layTexts({ size, text, background, title, captions, legends }: AnnotatedTexts): Texts {
  const results = call(
    "lay_texts",
    [Math.round(size.width), Math.round(size.height), text],
    [background.top, background.bottom],
    [title, listed(captions, (caption) => caption), listed(legends, legendItem)],
  );
  return { overlay: overlay(results), taken: results.list(() => box(results)) };
}
