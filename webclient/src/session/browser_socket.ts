// Where the server is, as seen from this page: beside it, under whatever prefix.
import type { SocketLike } from "../protocol/connection";

/** The server has turned a token in the address into a cookie; taken out here, it does not leave in a link. */
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
