// Keyboard shortcuts of the page. A control that uses a key stops the propagation of the key event.
import type { AxisView } from "../model/camera";
import type { Commands } from "./commands";

const TURN_PIXELS = 24;
const ZOOM_STEP = 0.85;
const GESTURE = "arrow-keys";

type KeyAction = (commands: Commands) => void;

const PLAIN: Record<string, KeyAction> = {
  r: (commands) => commands.camera.reset(),
  o: (commands) => commands.camera.toggleParallel(),
  s: (commands) => void commands.files.screenshot(),
  l: (commands) => void commands.files.copyLink(),
  p: (commands) => commands.page.togglePanel(),
  " ": (commands) => commands.time.togglePlay(),
  ",": (commands) => commands.time.stepBy(-1),
  ".": (commands) => commands.time.stepBy(1),
  "?": (commands) => commands.page.showHelp(true),
  escape: (commands) => commands.probe.close(),
  "+": (commands) => commands.camera.zoomBy(ZOOM_STEP),
  "=": (commands) => commands.camera.zoomBy(ZOOM_STEP),
  "-": (commands) => commands.camera.zoomBy(1 / ZOOM_STEP),
};

const ARROWS: Record<string, [number, number]> = {
  arrowleft: [-TURN_PIXELS, 0],
  arrowright: [TURN_PIXELS, 0],
  arrowup: [0, -TURN_PIXELS],
  arrowdown: [0, TURN_PIXELS],
};

function arrow(commands: Commands, [dx, dy]: [number, number], { shiftKey, repeat }: KeyboardEvent): void {
  if (shiftKey) commands.camera.panBy(dx, dy, GESTURE);
  else commands.camera.turnBy(dx, dy, GESTURE, !repeat);
}

function actionFor(event: KeyboardEvent): KeyAction | null {
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "z") return (commands) => (event.shiftKey ? commands.redo() : commands.undo());
    return key === "y" ? (commands) => commands.redo() : null;
  }
  if (event.altKey) return null;
  const move = ARROWS[key];
  if (key === "r" && event.shiftKey) return (commands) => commands.camera.reset(true);
  if (move !== undefined) return (commands) => arrow(commands, move, event);
  if (key === "x" || key === "y" || key === "z") {
    return (commands) => commands.camera.lookFrom(`${event.shiftKey ? "-" : "+"}${key}` as AxisView);
  }
  return PLAIN[key] ?? null;
}

const SLIDER_KEYS = /^(Arrow\w+|Home|End|Page\w+)$/;

/** Whether the focused control uses the key itself. Call only for keys without Control and Meta. */
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

export function handleKey(commands: Commands, event: KeyboardEvent): void {
  const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
  const modified = event.ctrlKey || event.metaKey;
  if (event.defaultPrevented || typing || pressesButton(event)) return;
  if (takesKey(event) && !modified) return;
  const action = actionFor(event);
  if (action === null) return;
  event.preventDefault();
  action(commands);
}
