// Hides overlays without room on the canvas; runs again when an overlay is added, removed or resized.
import { roomFor, type Box } from "../../model/overlay_room";

const HIDDEN = "data-crowded"; // the style sheet makes it invisible but keeps its layout

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
  const [triadElements, triad] = boxesOf(stage, ".triad");
  const room = roomFor(
    { captions, legends, triad },
    {
      width: stage.clientWidth,
      height: stage.clientHeight,
    },
  );
  legendElements.forEach((element, i) => {
    element.toggleAttribute(HIDDEN, room.legends[i] !== true);
    const { top = 0, bottom = 0 } = legends[i] ?? {};
    element.style.setProperty("--from", `${(100 * top) / stage.clientHeight}%`); // vertical extent in the background
    element.style.setProperty("--to", `${(100 * bottom) / stage.clientHeight}%`);
  });
  for (const element of triadElements) element.toggleAttribute(HIDDEN, !room.triad);
  return room.taken;
}

/** `changed` receives the boxes of the shown overlays when they change. Returns a function that stops observing. */
export function keepApart(stage: HTMLElement, changed: (taken: Box[]) => void): () => void {
  let last = "";
  const watched = new WeakSet<Element>();
  const again = (): void => {
    for (const element of stage.querySelectorAll(".captions, .legend, .triad")) {
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
      target instanceof Element && target.closest(".box-axes") !== null;
    if (!records.every(isAxes)) again();
  });
  parts.observe(stage, { childList: true, subtree: true });
  again();
  return () => {
    sizes.disconnect();
    parts.disconnect();
  };
}
