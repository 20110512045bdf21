// What stands between this page and a server that is there, and the token that may open it.
import type { Model } from "../model/model";
import { askRefusal, offerToken, tokenIn, type Fetch } from "./access";

const get: Fetch = (address, init) => fetch(address, init);

/** A server that has just come back answers calls before the next socket is tried. */
const TRIES_BEFORE_NO_SOCKET = 2;

export class Entry {
  private answered = 0;

  constructor(
    private readonly model: Model,
    private readonly retry: () => void,
  ) {}

  /** After a socket failed. */
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

  /** A sentence where it opens nothing. */
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
