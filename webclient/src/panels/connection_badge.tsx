import type { JSX } from "preact";
import { useAppState } from "./context";

export function ConnectionBadge(): JSX.Element {
  const connection = useAppState((state) => state.connection);
  const draining = useAppState((state) => state.draining);
  const stopping = draining && connection.kind === "open";
  const words = stopping
    ? "Server is stopping"
    : { connecting: "Connecting", open: "Connected", waiting: "Not connected", closed: "Closed" }[connection.kind];
  return (
    <span class={`badge ${stopping ? "waiting" : connection.kind}`} role="status">
      {words}
    </span>
  );
}
