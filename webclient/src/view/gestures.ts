// Converts pointer, wheel and touch events on the canvas to camera moves.
import { pan, roll, type ViewCamera, type Size } from "../model/camera";

export interface GestureTarget {
  camera(): ViewCamera | null;
  size(): Size; // size of the canvas in CSS pixels
  /** Returns the camera zoomed about pixel (x, y), or the same camera at the limit of zooming. */
  zoomed(camera: ViewCamera, factor: number, x: number, y: number): ViewCamera;
  /** Moves the camera. `gesture` is the same name from press to release. */
  move(camera: ViewCamera, gesture: string): void;
  newGesture(): string;
  /** Begins an orbit about the surface point at pixel (x, y). */
  turnsAbout(x: number, y: number): void;
  /** Orbits by (dx, dy) CSS pixels. */
  turn(dx: number, dy: number, gesture: string): void;
  click(x: number, y: number): void;
  doubleClick(x: number, y: number): void;
}

interface Finger {
  x: number;
  y: number;
}

type Drag = "orbit" | "pan" | "roll";

/** A press that moves by less than this many CSS pixels is a click. */
const CLICK_SLOP = 4;
/** Wheel events with pauses shorter than this are one gesture. */
const WHEEL_PAUSE_MS = 400;
const WHEEL_FACTOR_PER_PIXEL = 0.0015;
const PIXELS_PER_LINE = 16;

export function wheelFactor(delta: number, mode: number): number {
  const pixels = mode === 1 ? delta * PIXELS_PER_LINE : mode === 2 ? delta * 400 : delta;
  return Math.exp(Math.min(1, Math.max(-1, pixels * WHEEL_FACTOR_PER_PIXEL)));
}

export function dragOf(button: number, shift: boolean, control: boolean): Drag {
  if (control && button === 0) return "roll";
  return button === 0 && !shift ? "orbit" : "pan";
}

class Gestures {
  private readonly fingers = new Map<number, Finger>();
  private drag: Drag = "orbit";
  private gesture = "";
  private travelled = 0;
  private wheelGesture = "";
  private wheelAt = -Infinity;

  constructor(
    private readonly element: HTMLElement,
    private readonly target: GestureTarget,
  ) {
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.moved(event));
    element.addEventListener("pointerup", (event) => this.up(event, true));
    element.addEventListener("pointercancel", (event) => this.up(event, false));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("dblclick", (event) => {
      const { x, y } = this.at(event);
      this.target.doubleClick(x, y);
    });
  }

  private at(event: MouseEvent): Finger {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private down(event: PointerEvent): void {
    if (this.fingers.size === 0) {
      this.drag = dragOf(event.button, event.shiftKey, event.ctrlKey);
      this.gesture = this.target.newGesture();
      this.travelled = 0;
      const { x, y } = this.at(event);
      if (this.drag === "orbit") this.target.turnsAbout(x, y);
    } else {
      this.travelled = Infinity; // a gesture of two fingers is never a click
    }
    this.fingers.set(event.pointerId, this.at(event));
    this.element.setPointerCapture(event.pointerId);
    this.element.focus({ preventScroll: true });
    event.preventDefault();
  }

  private moved(event: PointerEvent): void {
    const before = this.fingers.get(event.pointerId);
    if (before === undefined) return;
    const now = this.at(event);
    const others = [...this.fingers].filter(([id]) => id !== event.pointerId).map(([, finger]) => finger);
    this.fingers.set(event.pointerId, now);
    this.travelled += Math.hypot(now.x - before.x, now.y - before.y);
    if (this.travelled < CLICK_SLOP) return;
    const [other] = others;
    if (other === undefined && this.drag === "orbit") {
      this.target.turn(now.x - before.x, now.y - before.y, this.gesture);
      return;
    }
    const camera = this.target.camera();
    if (camera === null) return;
    const next = other === undefined ? this.dragged(camera, before, now) : this.pinched(camera, before, now, other);
    this.target.move(next, this.gesture);
  }

  private dragged(camera: ViewCamera, before: Finger, now: Finger): ViewCamera {
    const size = this.target.size();
    if (this.drag === "pan") return pan(camera, now.x - before.x, now.y - before.y, size);
    const angle = ({ x, y }: Finger): number => Math.atan2(y - size.height / 2, x - size.width / 2);
    return roll(camera, angle(before) - angle(now));
  }

  private pinched(camera: ViewCamera, before: Finger, now: Finger, other: Finger): ViewCamera {
    const size = this.target.size();
    const spread = (finger: Finger): number => Math.max(1, Math.hypot(finger.x - other.x, finger.y - other.y));
    const moved = pan(camera, (now.x - before.x) / 2, (now.y - before.y) / 2, size);
    const factor = spread(before) / spread(now);
    return this.target.zoomed(moved, factor, (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  private up(event: PointerEvent, released: boolean): void {
    if (!this.fingers.delete(event.pointerId)) return;
    if (released && this.fingers.size === 0 && this.travelled < CLICK_SLOP && event.button === 0) {
      const { x, y } = this.at(event);
      this.target.click(x, y);
    }
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const camera = this.target.camera();
    if (camera === null) return;
    if (event.timeStamp - this.wheelAt > WHEEL_PAUSE_MS) this.wheelGesture = this.target.newGesture();
    this.wheelAt = event.timeStamp;
    const { x, y } = this.at(event);
    // Browsers report a pinch on a touch pad as wheel events with the control key and with far smaller deltas.
    const factor = wheelFactor(event.ctrlKey ? event.deltaY * 6 : event.deltaY, event.deltaMode);
    const next = this.target.zoomed(camera, factor, x, y);
    if (next !== camera) this.target.move(next, this.wheelGesture);
  }
}

/** Listens for gestures on the element, for the whole lifetime of the element. */
export function listenToGestures(element: HTMLElement, target: GestureTarget): void {
  new Gestures(element, target);
}
