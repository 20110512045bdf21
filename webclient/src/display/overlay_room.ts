// What lies over the canvas keeps clear of each other, by the rule of server/render/annotations/page.hpp: captions, legends, triad,
// axes; what comes later gives way. Places are CSS pixels of the stage.
import type { Size } from "../camera/camera";

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
