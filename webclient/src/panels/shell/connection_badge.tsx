import type { JSX } from "preact";
import { useModel } from "../context";

export function ConnectionBadge(): JSX.Element {
  const connection = useModel((model) => model.connection.value);
  const draining = useModel((model) => model.draining.value);
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
