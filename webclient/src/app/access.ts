// What stands between this page and a server that is there, and the token that may open it.
import { askRefusal, offerToken, tokenIn, type Fetch } from "../session/access";
import type { App } from "./app";

const get: Fetch = (address, init) => fetch(address, init);

/** A server that has just come back answers calls before the next socket is tried. */
const TRIES_BEFORE_NO_SOCKET = 2;

export class Access {
  private answered = 0;

  constructor(private readonly app: App) {}

  /** After a socket failed. */
  async explain(): Promise<void> {
    const refusal = await askRefusal(document.baseURI, get);
    if (this.app.store.get().connection.kind === "open") return;
    this.answered = refusal?.kind === "no-socket" ? this.answered + 1 : 0;
    const sure = refusal?.kind !== "no-socket" || this.answered >= TRIES_BEFORE_NO_SOCKET;
    this.app.store.set({ refusal: sure ? refusal : null });
  }

  opened(): void {
    this.answered = 0;
    this.app.store.set({ refusal: null });
  }

  /** A sentence where it opens nothing. */
  async enter(typed: string): Promise<string | null> {
    try {
      if (!(await offerToken(document.baseURI, tokenIn(typed), get))) return "This is not the server's token.";
      this.app.session.retryNow();
      return null;
    } catch (error) {
      return error instanceof TypeError ? "The server does not answer now." : (error as Error).message;
    }
  }
}
