// What lies over the canvas keeps clear of each other, by the rule of server/annotations/layout.hpp: captions, legends, triad,
// axes; what comes later gives way. Places are CSS pixels of the stage.
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
  /** In their order, the first column at the right. */
  legends: Box[];
  triad: Box[];
}

export interface Room {
  /** Which legends are shown: those before the first that has no room. */
  legends: boolean[];
  triad: boolean;
  /** What stands there, for the axes to keep clear of. */
  taken: Box[];
}

const LEAST_SHARE = 1 / 3;
const LEAST_SHARE_OF_FURTHER = 1 / 2; // the picture is what it is for

/** Of legends, in pixels: smaller in small pictures, and a page is read from nearer than a picture of it. */
const USUAL_TEXT = 12;
const SMALLEST_TEXT = 9;
const USUAL_HEIGHT = 560;

/** A legend would fill a narrow picture. */
export function legendText({ width, height }: Size): number {
  return clamp((USUAL_TEXT * Math.min(height, 0.75 * width)) / USUAL_HEIGHT, SMALLEST_TEXT, USUAL_TEXT);
}

/** Of the height; ems. */
const BAR_SHARE = 0.26;
const LEAST_BAR = 5;
const MOST_BAR = 14;
const AROUND_BAR = 5;
/** Pixels: buttons below a bar, and between legends. */
const BESIDE_BARS = 40;

/** How high the bars are of which so many stand in one column where they can. */
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
