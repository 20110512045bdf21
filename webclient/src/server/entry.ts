// Finds out why a reachable server refuses this page, and offers a token to it.
import type { Model } from "../model/model";
import { askRefusal, offerToken, tokenIn, type Fetch } from "./access";

const get: Fetch = (address, init) => fetch(address, init);

/** A restarted server answers calls before the next socket attempt, so one answer is no proof. */
const TRIES_BEFORE_NO_SOCKET = 2;

export class Entry {
  private answered = 0;

  constructor(
    private readonly model: Model,
    private readonly retry: () => void,
  ) {}

  /** Call after a socket failed. */
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

  /** Returns null if the token was accepted, else a sentence for the user. */
  async enter(typed: string): Promise<string | null> {
    try {
      if (!(await offerToken(document.baseURI, tokenIn(typed), get))) return "This is not the server's token.";
      this.retry();
      return null;
    } catch (error) {
      return error instanceof TypeError ? "The server does not answer now." : (error as Error).message;
    }
  }
}
