// Hides overlays that have no room on the canvas. Runs again when an overlay is added, removed or resized.
import { roomFor } from "../../model/overlay_room";
import type { Box } from "../../wasm/overlay";

const HIDDEN = "data-crowded"; // attribute of hidden overlays; they keep their layout

function boxesOf(stage: HTMLElement, selector: string): [HTMLElement[], Box[]] {
  const { left, top } = stage.getBoundingClientRect();
  const elements = [...stage.querySelectorAll<HTMLElement>(selector)];
  const boxes = elements.map((element) => {
    const box = element.getBoundingClientRect();
    return { left: box.left - left, top: box.top - top, right: box.right - left, bottom: box.bottom - top };
  });
  return [elements, boxes];
}

function arrange(stage: HTMLElement): Box[] {
  const [, captions] = boxesOf(stage, ".captions");
  const [legendElements, legends] = boxesOf(stage, ".legend");
  const room = roomFor(
    { captions, legends },
    {
      width: stage.clientWidth,
      height: stage.clientHeight,
    },
  );
  legendElements.forEach((element, i) => {
    element.toggleAttribute(HIDDEN, room.legends[i] !== true);
    const { top = 0, bottom = 0 } = legends[i] ?? {};
    element.style.setProperty("--from", `${(100 * top) / stage.clientHeight}%`); // top in the background gradient
    element.style.setProperty("--to", `${(100 * bottom) / stage.clientHeight}%`);
  });
  return room.taken;
}

/**
 * Watches the overlays of the stage. Calls `changed` with the boxes of the shown ones when they change. Returns a
 * function that stops watching.
 */
export function keepApart(stage: HTMLElement, changed: (taken: Box[]) => void): () => void {
  let last = "";
  const watched = new WeakSet<Element>();
  const again = (): void => {
    for (const element of stage.querySelectorAll(".captions, .legend")) {
      if (!watched.has(element)) sizes.observe(element);
      watched.add(element);
    }
    const taken = arrange(stage);
    const key = JSON.stringify(taken);
    if (key !== last) changed(taken);
    last = key;
  };
  const sizes = new ResizeObserver(again);
  sizes.observe(stage);
  const parts = new MutationObserver((records) => {
    const isAxes = ({ target }: MutationRecord): boolean =>
      target instanceof Element && target.closest(".annotations") !== null;
    if (!records.every(isAxes)) again();
  });
  parts.observe(stage, { childList: true, subtree: true });
  again();
  return () => {
    sizes.disconnect();
    parts.disconnect();
  };
}
