// Finds the reason why a reachable server refuses this page, and sends the token that the user enters.
import type { Model } from "../model/model";
import { askRefusal, offerToken, tokenIn, type Fetch } from "./access";

const get: Fetch = (address, init) => fetch(address, init);

/**
 * HTTP answers after which a blocked WebSocket is reported. One answer is not enough, because a restarted server
 * answers HTTP before the page tries a WebSocket again.
 */
const TRIES_BEFORE_NO_SOCKET = 2;

export class Entry {
  private answered = 0;

  constructor(
    private readonly model: Model,
    private readonly retry: () => void,
  ) {}

  /** Call after each failure of the WebSocket. */
  async explain(): Promise<void> {
    const refusal = await askRefusal(document.baseURI, get);
    if (this.model.connection.peek().kind === "open") return;
    this.answered = refusal?.kind === "no-socket" ? this.answered + 1 : 0;
    const sure = refusal?.kind !== "no-socket" || this.answered >= TRIES_BEFORE_NO_SOCKET;
    this.model.refusal.value = sure ? refusal : null;
  }

  opened(): void {
    this.answered = 0;
    this.model.refusal.value = null;
  }

  /** Returns an error sentence, or null if the server accepted the token. */
  async enter(typed: string): Promise<string | null> {
    try {
      if (!(await offerToken(document.baseURI, tokenIn(typed), get)))
        return "The token is wrong. Copy the token from the address that the server printed at its start.";
      this.retry();
      return null;
    } catch (error) {
      return error instanceof TypeError ? "The server does not answer. Try again later." : (error as Error).message;
    }
  }
}
