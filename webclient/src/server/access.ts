// Asks the server over HTTP why it refuses the WebSocket, because browsers do not tell a page why a WebSocket failed.
import type { Refusal } from "../model/state";

export type Fetch = (address: URL, init?: RequestInit) => Promise<Response>;

const CALL = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "server.info", params: {} });
const LONGEST_SENTENCE = 300;

async function sentenceOf(response: Response): Promise<string> {
  const type = response.headers.get("Content-Type") ?? "";
  const text = type.startsWith("text/plain") ? (await response.text()).trim() : "";
  if (text !== "" && text.length <= LONGEST_SENTENCE) return text;
  return `${new URL(response.url).host} is not a CIEL server; check the address. Its answer was ${response.status} ${response.statusText}`.trim();
}

/** Returns null if no server answers over HTTP. `base`: the page's address. */
export async function askRefusal(base: string, fetch: Fetch): Promise<Refusal | null> {
  try {
    const headers = { "Content-Type": "application/json" };
    const response = await fetch(new URL("rpc", base), { method: "POST", headers, body: CALL });
    if (response.status === 401) return { kind: "token" };
    if (response.ok) return { kind: "no-socket" };
    return { kind: "refused", words: await sentenceOf(response) };
  } catch {
    return null;
  }
}

/** Accepts a bare token, or the whole address that the server printed. */
export function tokenIn(typed: string): string {
  const text = typed.trim();
  const query = /\?[^#]*/.exec(text)?.[0];
  return (query === undefined ? null : new URLSearchParams(query).get("token")) ?? text;
}

/** Returns false if the token is wrong. Throws Error if the server refuses for another reason. */
export async function offerToken(base: string, token: string, fetch: Fetch): Promise<boolean> {
  const address = new URL("./", base);
  address.searchParams.set("token", token);
  const response = await fetch(address, { cache: "no-store" });
  if (response.ok || response.status === 401) return response.ok;
  throw new Error(await sentenceOf(response));
}
