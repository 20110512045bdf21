// Stored in the browser: theme and stream permanently, the session for the tab's lifetime.
import { decodeSession, encodeSession } from "../model/link";
import type { StreamChoice, Theme } from "../model/state";

const THEME = "ciel.theme";
const SESSION = "ciel.session";
const STREAM = "ciel.stream";

function read(storage: () => Storage, key: string): string | null {
  try {
    return storage().getItem(key);
  } catch {
    return null; // storage may be forbidden
  }
}

function write(storage: () => Storage, key: string, value: string): void {
  try {
    storage().setItem(key, value);
  } catch {
    // Storage may be forbidden: the value is lost with the page.
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

/** The tab's session: the address's, else the stored one, else a new random id. */
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

export function isDark(theme: Theme): boolean {
  return theme === "dark" || (theme === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
}
