// Keeps overlays of the canvas apart, by the rule of server/annotations/layout.hpp. Priority: captions, legends, triad,
// axes; the later one gives way. Coordinates are CSS pixels of the stage.
import type { Size } from "./camera";
import { clamp } from "./numbers";

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Overlays {
  captions: Box[];
  /** In legend order, the first column at the right. */
  legends: Box[];
  triad: Box[];
}

export interface Room {
  /** Whether each legend is shown: those before the first without room. */
  legends: boolean[];
  triad: boolean;
  /** Boxes of the shown overlays; the axes avoid them. */
  taken: Box[];
}

const LEAST_SHARE = 1 / 3;
const LEAST_SHARE_OF_FURTHER = 1 / 2; // further columns leave half for the picture

/** Legend text in pixels: smaller in small pictures. A page is read from closer than a saved picture. */
const USUAL_TEXT = 12;
const SMALLEST_TEXT = 9;
const USUAL_HEIGHT = 560;

/** Text size in pixels. The width limits it too: a legend would fill a narrow picture. */
export function legendText({ width, height }: Size): number {
  return clamp((USUAL_TEXT * Math.min(height, 0.75 * width)) / USUAL_HEIGHT, SMALLEST_TEXT, USUAL_TEXT);
}

/** Bar height as a share of the picture's height; its limits and the room around it in ems. */
const BAR_SHARE = 0.26;
const LEAST_BAR = 5;
const MOST_BAR = 14;
const AROUND_BAR = 5;
/** Pixels for the buttons below a bar and the gap between legends. */
const BESIDE_BARS = 40;

/** Bar height in pixels at which `count` legends fit into one column where possible. */
export function barHeight({ height }: Size, count: number, text: number): number {
  const shared = height / Math.max(1, count) - AROUND_BAR * text - BESIDE_BARS;
  return clamp(Math.min(BAR_SHARE * height, shared), LEAST_BAR * text, MOST_BAR * text);
}

export const overlaps = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

export function roomFor({ captions, legends, triad }: Overlays, stage: Size): Room {
  const taken = [...captions];
  const isFree = (box: Box): boolean =>
    box.left >= 0 &&
    box.top >= 0 &&
    box.right <= stage.width &&
    box.bottom <= stage.height &&
    !taken.some((other) => overlaps(other, box));
  const [first] = legends;
  let full = false;
  const shown = legends.map((box) => {
    const share = first !== undefined && box.left < first.left ? LEAST_SHARE_OF_FURTHER : LEAST_SHARE;
    full ||= box.left < share * stage.width || !isFree(box);
    if (!full) taken.push(box);
    return !full;
  });
  const hasRoom = triad.every(isFree);
  if (hasRoom) taken.push(...triad);
  return { legends: shown, triad: hasRoom, taken };
}
