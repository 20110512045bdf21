// Short messages that go by themselves.
import type { AppState } from "./state";
import type { Store } from "./store";

const SHOWN_MS = 9000;
const MOST = 4;

export class Toasts {
  private nextId = 1;

  constructor(private readonly store: Store<AppState>) {}

  show(text: string, kind: "error" | "info" = "info"): void {
    const { toasts } = this.store.get();
    if (toasts.some((toast) => toast.text === text)) return;
    const toast = { id: this.nextId++, kind, text };
    this.store.set({ toasts: [...toasts.slice(1 - MOST), toast] });
    setTimeout(() => this.dismiss(toast.id), SHOWN_MS);
  }

  dismiss(id: number): void {
    this.store.set({ toasts: this.store.get().toasts.filter((toast) => toast.id !== id) });
  }
}
