// Connects to the server by WebSocket and HTTP, at addresses relative to the page.
import type { SocketLike } from "./connection";
import { Disconnected, type Post } from "./rpc";

/**
 * Removes the token from the page's address, because copied links must not contain the token. The server has already
 * stored the token in a cookie.
 */
export function hideToken(): void {
  const address = new URL(location.href);
  if (!address.searchParams.has("token")) return;
  address.searchParams.delete("token");
  history.replaceState(null, "", address);
}

export function socketAddress(base: string): URL {
  const address = new URL("ws", base);
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  return address;
}

export function openSocket(address: URL): SocketLike {
  return new WebSocket(address, ["ciel.v1"]) as unknown as SocketLike;
}

export function postTo(base: string): Post {
  const headers = { "Content-Type": "application/json" };
  return async (body, signal) => {
    const answer = await fetch(new URL("rpc", base), { method: "POST", headers, body, signal }).catch(() => {
      throw new Disconnected();
    });
    const text = await answer.text();
    if (!answer.ok) throw new Error(text);
    return text;
  };
}
