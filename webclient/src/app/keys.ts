// Keys of the whole page. Controls that use a key themselves stop it before it comes here.
import { orbit, pan, type AxisView } from "../camera/camera";
import type { App } from "./app";

const TURN_PIXELS = 24;
const ZOOM_STEP = 0.85;

type KeyAction = (app: App) => void;

const PLAIN: Record<string, KeyAction> = {
  r: (app) => app.actions.resetView(),
  o: (app) => app.actions.toggleParallel(),
  s: (app) => void app.actions.screenshot(),
  l: (app) => void app.actions.copyLink(),
  p: (app) => app.store.set({ panelOpen: !app.store.get().panelOpen }),
  " ": (app) => app.actions.togglePlay(),
  ",": (app) => app.actions.stepBy(-1),
  ".": (app) => app.actions.stepBy(1),
  "?": (app) => app.store.set({ helpOpen: true }),
  escape: (app) => app.store.set({ probe: null }),
  "+": (app) => zoomBy(app, ZOOM_STEP),
  "=": (app) => zoomBy(app, ZOOM_STEP),
  "-": (app) => zoomBy(app, 1 / ZOOM_STEP),
};

const ARROWS: Record<string, [number, number]> = {
  arrowleft: [-TURN_PIXELS, 0],
  arrowright: [TURN_PIXELS, 0],
  arrowup: [0, -TURN_PIXELS],
  arrowdown: [0, TURN_PIXELS],
};

function zoomBy(app: App, factor: number): void {
  const camera = app.actions.camera();
  const { css } = app.size;
  if (camera === null) return;
  const next = app.actions.zoomed(camera, factor, css.width / 2, css.height / 2);
  if (next !== camera) app.actions.setCamera(next);
}

function arrow(app: App, [dx, dy]: [number, number], { shiftKey, repeat }: KeyboardEvent): void {
  const camera = app.actions.camera();
  const { css } = app.size;
  if (camera === null) return;
  if (!shiftKey && !repeat) app.pivot.seek(css.width / 2, css.height / 2);
  const next = shiftKey ? pan(camera, dx, dy, css) : orbit(camera, dx, dy, css, app.pivot.of(camera));
  app.actions.setCamera(next, "arrow-keys");
}

function actionFor(event: KeyboardEvent): KeyAction | null {
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "z") return (app) => (event.shiftKey ? app.actions.redo() : app.actions.undo());
    return key === "y" ? (app) => app.actions.redo() : null;
  }
  if (event.altKey) return null;
  const move = ARROWS[key];
  if (key === "r" && event.shiftKey) return (app) => app.actions.resetView(true);
  if (move !== undefined) return (app) => arrow(app, move, event);
  if (key === "x" || key === "y" || key === "z") {
    return (app) => app.actions.lookFrom(`${event.shiftKey ? "-" : "+"}${key}` as AxisView);
  }
  return PLAIN[key] ?? null;
}

const SLIDER_KEYS = /^(Arrow\w+|Home|End|Page\w+)$/;

/** Whether the focused control wants a plain key for itself. */
function takesKey({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  const control = target.closest("input, select, textarea, dialog, .menu-body");
  if (!(control instanceof HTMLInputElement)) return control !== null;
  if (control.closest("dialog, .menu-body") !== null) return true;
  if (control.type === "checkbox") return key === " ";
  return control.type !== "range" || SLIDER_KEYS.test(key);
}

function pressesButton(event: KeyboardEvent): boolean {
  return event.key === " " && event.target instanceof Element && event.target.closest("button") !== null;
}

export function handleKey(app: App, event: KeyboardEvent): void {
  const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
  const modified = event.ctrlKey || event.metaKey;
  if (event.defaultPrevented || typing || pressesButton(event)) return;
  if (takesKey(event) && !modified) return;
  const action = actionFor(event);
  if (action === null) return;
  event.preventDefault();
  action(app);
}
