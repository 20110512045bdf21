// Moves handles on a track by pointer or keyboard. Each handle has the attribute data-index with its index.
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { clamp } from "../../model/numbers";

interface Options {
  newGesture: () => string;
  /** Called for a press outside all handles. Returns the index of the handle to drag; null for no drag. */
  pressed: (place: Place, gesture: string) => number | null;
  moved: (index: number, place: Place, gesture: string) => void;
}

/** Position on the track. x: 0 at the left to 1 at the right; y: 0 at the bottom to 1 at the top. */
export interface Place {
  x: number;
  y: number;
}

interface HandleDrag {
  track: RefObject<HTMLDivElement>;
  pointer: {
    onPointerDown: (event: PointerEvent) => void;
    onPointerMove: (event: PointerEvent) => void;
    onPointerUp: () => void;
    onPointerCancel: () => void;
  };
  /** Returns the gesture name for a key event. The name stays the same while the key is held down. */
  keyGesture: (event: KeyboardEvent) => string;
}

function placeOn(track: Element | null, event: PointerEvent): Place {
  const box = track?.getBoundingClientRect();
  if (box === undefined) return { x: 0, y: 0 };
  return {
    x: clamp((event.clientX - box.left) / box.width, 0, 1),
    y: clamp(1 - (event.clientY - box.top) / box.height, 0, 1),
  };
}

export function useHandleDrag(options: Options): HandleDrag {
  const track = useRef<HTMLDivElement>(null);
  const held = useRef<{ index: number; gesture: string } | null>(null);
  const keys = useRef("");
  const latest = useRef(options); // pointer events may arrive before the next rendering
  useEffect(() => void (latest.current = options));

  const focus = (index: number): void => track.current?.querySelector<HTMLElement>(`[data-index="${index}"]`)?.focus();
  const release = (): void => void (held.current = null);
  const onPointerDown = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const handle = (event.target as Element).closest<HTMLElement>("[data-index]");
    const gesture = options.newGesture();
    const index =
      handle === null ? options.pressed(placeOn(track.current, event), gesture) : Number(handle.dataset.index);
    if (index === null) return;
    held.current = { index, gesture };
    track.current?.setPointerCapture(event.pointerId);
    event.preventDefault();
    focus(index);
    if (handle === null) requestAnimationFrame(() => focus(index)); // pressed() may have added the handle
  };
  const onPointerMove = (event: PointerEvent): void => {
    if (held.current === null) return;
    latest.current.moved(held.current.index, placeOn(track.current, event), held.current.gesture);
  };
  const keyGesture = (event: KeyboardEvent): string => {
    if (!event.repeat || keys.current === "") keys.current = options.newGesture();
    return keys.current;
  };
  return {
    track,
    pointer: { onPointerDown, onPointerMove, onPointerUp: release, onPointerCancel: release },
    keyGesture,
  };
}
