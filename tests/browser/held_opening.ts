// Page script that holds back messages while `holding` is true: the description of a chosen dataset, then its first
// picture. `held` names the newest message that is held back; `pass` delivers all of them. `letGo` does so, too, and
// holds nothing more: in one step, because no message may overtake an earlier one.

interface HoldingPage {
  holding: boolean;
  held: string | null;
  pass: () => void;
  letGo: () => void;
}

/** Runs in the page: replaces WebSocket by a class that holds messages back. */
function hold(): void {
  const Plain = WebSocket;
  const page = globalThis as unknown as HoldingPage;
  const waiting: (() => void)[] = [];
  page.holding = false;
  page.held = null;
  page.pass = () => {
    page.held = null;
    for (const deliver of waiting.splice(0)) deliver();
  };
  page.letGo = () => {
    page.holding = false;
    page.pass();
  };
  window.WebSocket = class extends Plain {
    private listener: ((event: MessageEvent) => void) | null = null;
    private readonly asked = new Set<number>();

    constructor(address: string | URL, protocols?: string | string[]) {
      super(address, protocols);
      this.addEventListener("message", (event) => this.receive(event as MessageEvent<string | ArrayBuffer>));
    }

    override set onmessage(listener: ((event: MessageEvent) => void) | null) {
      this.listener = listener;
    }

    override send(text: string): void {
      const { id, method } = JSON.parse(text) as { id: number; method: string };
      if (method === "dataset.describe" && page.holding) this.asked.add(id);
      super.send(text);
    }

    private receive(event: MessageEvent<string | ArrayBuffer>): void {
      const { data } = event;
      const isPicture = typeof data !== "string";
      const isDescription = !isPicture && this.asked.delete((JSON.parse(data) as { id?: number }).id ?? -1);
      if (!page.holding || !(isPicture || isDescription)) this.listener?.(event);
      else {
        page.held = isPicture ? "picture" : "description";
        waiting.push(() => this.listener?.(event));
      }
    }
  };
}

export const heldOpening = `(${hold.toString()})()`;
