// Page script that holds back stills while `holding` is true, as if the server took long to draw them.

/** Runs in the page: replaces WebSocket by a class that holds messages back. */
function hold(): void {
  const Plain = WebSocket;
  const STILL = 1;
  const page = globalThis as unknown as { holding: boolean; held: (() => void)[] };
  page.held = [];
  window.WebSocket = class extends Plain {
    private listener: ((event: MessageEvent) => void) | null = null;

    constructor(address: string | URL, protocols?: string | string[]) {
      super(address, protocols);
      this.addEventListener("message", (event) => this.pass(event as MessageEvent<string | ArrayBuffer>));
    }

    override set onmessage(listener: ((event: MessageEvent) => void) | null) {
      this.listener = listener;
    }

    private pass(event: MessageEvent<string | ArrayBuffer>): void {
      const { data } = event;
      const isStill = typeof data !== "string" && (new DataView(data).getUint16(6, true) & STILL) !== 0;
      if (isStill && page.holding) page.held.push(() => this.listener?.(event));
      else this.listener?.(event);
    }
  };
}

export const heldStill = `(${hold.toString()})()`;
export const beginHolding = "globalThis.holding = true";
export const letGo = "globalThis.holding = false; for (const pass of globalThis.held.splice(0)) pass()";
