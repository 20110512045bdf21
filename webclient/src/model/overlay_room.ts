// Decides which legends of the canvas have room beside the captions, by the rule of server/annotations/layout.hpp. The
// first legend without room and all later ones are hidden. Coordinates are CSS pixels of the stage.
import type { Box } from "../wasm/overlay";
import type { Size } from "./camera";
import { clamp } from "./numbers";

export interface Overlays {
  captions: Box[];
  /** Boxes of the legends in order, column by column from the right. */
  legends: Box[];
}

export interface Room {
  /** Whether each legend is shown. False for the first legend without room and for all later ones. */
  legends: boolean[];
  /** Boxes of the shown captions and legends. The triad and the axes avoid them. */
  taken: Box[];
}

const LEAST_SHARE = 1 / 3;
const LEAST_SHARE_OF_FURTHER = 1 / 2; // legend columns after the first leave half of the width free

/**
 * Size of legend text in pixels: USUAL_TEXT from a picture height of USUAL_HEIGHT on, less in smaller pictures. Text
 * may be smaller than in saved pictures, since a page is read from close up.
 */
const USUAL_TEXT = 12;
const SMALLEST_TEXT = 9;
const USUAL_HEIGHT = 560;

/** Text size of legends in CSS pixels. It also depends on the width, because a legend would fill a narrow picture. */
export function legendText({ width, height }: Size): number {
  return clamp((USUAL_TEXT * Math.min(height, 0.75 * width)) / USUAL_HEIGHT, SMALLEST_TEXT, USUAL_TEXT);
}

/** Height of a legend's bar as a share of the picture's height, then in ems its limits and the room above and below. */
const BAR_SHARE = 0.26;
const LEAST_BAR = 5;
const MOST_BAR = 14;
const AROUND_BAR = 5;
/** CSS pixels for the buttons below a bar and the gap between legends. */
const BESIDE_BARS = 40;

/** Height of a legend's bar in CSS pixels. If possible, `count` legends fit into one column. */
export function barHeight({ height }: Size, count: number, text: number): number {
  const shared = height / Math.max(1, count) - AROUND_BAR * text - BESIDE_BARS;
  return clamp(Math.min(BAR_SHARE * height, shared), LEAST_BAR * text, MOST_BAR * text);
}

export const overlaps = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

export function roomFor({ captions, legends }: Overlays, stage: Size): Room {
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
  return { legends: shown, taken };
}
