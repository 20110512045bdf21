// Short messages at the edge of the page that disappear after some seconds.
import type { Model } from "./model";

const SHOWN_MS = 9000;
const MOST = 4;

let nextId = 1;

export function showToast(model: Model, text: string, kind: "error" | "info" = "info"): void {
  const toasts = model.toasts.peek();
  if (toasts.some((toast) => toast.text === text)) return;
  const toast = { id: nextId++, kind, text };
  model.toasts.value = [...toasts.slice(1 - MOST), toast];
  setTimeout(() => dismissToast(model, toast.id), SHOWN_MS);
}

export function dismissToast(model: Model, id: number): void {
  model.toasts.value = model.toasts.peek().filter((toast) => toast.id !== id);
}
