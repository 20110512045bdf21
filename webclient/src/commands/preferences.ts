// Settings stored in the browser: theme and stream permanently, the session and its undo steps until the tab is closed.
import { decodeSession, encodeSession } from "../model/link";
import type { StreamChoice, Theme } from "../model/state";

const THEME = "ciel.theme";
const SESSION = "ciel.session";
const STEPS = "ciel.steps";
const STREAM = "ciel.stream";

function read(storage: () => Storage, key: string): string | null {
  try {
    return storage().getItem(key);
  } catch {
    return null; // the browser may forbid storage
  }
}

function write(storage: () => Storage, key: string, value: string): void {
  try {
    storage().setItem(key, value);
  } catch {
    // The browser may forbid storage. The setting is then lost when the page is closed.
  }
}

const local = (): Storage => localStorage;
const tab = (): Storage => sessionStorage;

export function savedTheme(): Theme {
  const theme = read(local, THEME);
  return theme === "dark" || theme === "light" ? theme : "system";
}

export const saveTheme = (theme: Theme): void => write(local, THEME, theme);

export function savedStream(): StreamChoice {
  const stream = read(local, STREAM);
  return stream === "image" || stream === "jpeg" || stream === "geometry" ? stream : "auto";
}

export const saveStream = (stream: string): void => write(local, STREAM, stream);

/** Uses the id in the page's address, or the stored id. Otherwise makes a new random id, and `known` is false. */
export function tabSession(): { id: string; known: boolean } {
  const known = decodeSession(location.hash) ?? decodeSession(encodeSession(read(tab, SESSION) ?? ""));
  if (known !== null) {
    write(tab, SESSION, known);
    return { id: known, known: true };
  }
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  const id = Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  write(tab, SESSION, id);
  return { id, known: false };
}

/** Text of this session's undo steps that saveSteps() stored before a reload of the page; empty if there is none. */
export function savedSteps(session: string): string {
  const saved = read(tab, STEPS) ?? "";
  return saved.startsWith(`${session} `) ? saved.slice(session.length + 1) : "";
}

export const saveSteps = (session: string, text: string): void => write(tab, STEPS, `${session} ${text}`);

export function isDark(theme: Theme): boolean {
  return theme === "dark" || (theme === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
}
