// Page script that delivers the answer to view.open only after the view's first frame, which protocol/frame.md allows.

/** Runs in the page: replaces WebSocket by a class that delays the answer. */
function hold(): void {
  const Plain = WebSocket;
  const LAST_OF_FRAME = 2;
  window.WebSocket = class extends Plain {
    private listener: ((event: MessageEvent) => void) | null = null;
    private opening: number | null = null;
    private answer: MessageEvent | null = null;
    private frames = 0;

    constructor(address: string | URL, protocols?: string | string[]) {
      super(address, protocols);
      this.addEventListener("message", (event) => this.pass(event as MessageEvent<string | ArrayBuffer>));
    }

    override set onmessage(listener: ((event: MessageEvent) => void) | null) {
      this.listener = listener;
    }

    override send(text: string): void {
      const { id, method } = JSON.parse(text) as { id: number; method: string };
      if (method === "view.open") this.opening = id;
      super.send(text);
    }

    private pass(event: MessageEvent<string | ArrayBuffer>): void {
      const { data } = event;
      if (typeof data !== "string") {
        if ((new DataView(data).getUint16(6, true) & LAST_OF_FRAME) !== 0) this.frames += 1;
        this.listener?.(event);
      } else if (this.opening !== null && (JSON.parse(data) as { id?: number }).id === this.opening) {
        this.answer = event;
      } else this.listener?.(event);
      if (this.answer === null || this.frames === 0) return;
      this.listener?.(this.answer);
      this.answer = null;
    }
  };
}

export const lateAnswer = `(${hold.toString()})()`;
