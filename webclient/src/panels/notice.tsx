// What stands in the way of a live picture, in full sentences.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { useApp, useAppState } from "./context";

/** Whole seconds until `at`, counting down. */
function useCountdown(at: number | null): number {
  const [now, setNow] = useState(Date.now);
  useEffect(() => {
    if (at === null) return;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 250);
    return () => clearInterval(timer);
  }, [at]);
  return at === null ? 0 : Math.max(0, Math.ceil((at - now) / 1000));
}

export function ConnectionNotice(): JSX.Element | null {
  const { session } = useApp();
  const connection = useAppState((state) => state.connection);
  const hasPicture = useAppState((state) => state.readout.stream !== "none");
  const draining = useAppState((state) => state.draining);
  const seconds = useCountdown(connection.kind === "waiting" ? connection.retryAt : null);
  if (connection.kind === "open" || connection.kind === "closed") return null;
  if (connection.kind === "connecting" && connection.attempt === 0) return null;
  const when = connection.kind === "connecting" ? "Trying now." : `Next try in ${seconds} s.`;
  const online = navigator.onLine;
  return (
    <div class={hasPicture ? "banner" : "notice"} role="alert">
      <strong>{online ? "The server does not answer" : "This computer is offline"}</strong>
      <p>
        {hasPicture
          ? `The picture is from before. Your scene is kept and comes back with the connection. ${when}`
          : `${location.host} cannot be reached. Is "ciel serve" running there? ${when}`}
        {draining && " The server said that it was stopping."}
      </p>
      <button type="button" class="button primary" onClick={() => session.retryNow()}>
        Try now
      </button>
    </div>
  );
}

export function FatalNotice(): JSX.Element | null {
  const fatal = useAppState((state) => state.fatal);
  const connected = useAppState((state) => state.connection.kind === "open");
  if (fatal === null || !connected) return null;
  return (
    <div class="notice" role="alert">
      <strong>Nothing can be shown</strong>
      <p>{fatal}</p>
    </div>
  );
}

export function Busy(): JSX.Element | null {
  const busy = useAppState((state) => state.busy);
  const waiting = useAppState(
    (state) => state.connection.kind === "open" && state.readout.stream === "none" && state.fatal === null,
  );
  const words = busy ?? (waiting ? "Opening" : null);
  if (words === null) return null;
  return (
    <div class="busy" role="status">
      {words}
    </div>
  );
}

export function ToastList(): JSX.Element {
  const { toasts } = useApp();
  const shown = useAppState((state) => state.toasts);
  return (
    <div class="toasts" aria-live="polite">
      {shown.map(({ id, kind, text }) => (
        <div key={id} class={`toast ${kind}`} role={kind === "error" ? "alert" : "status"}>
          <span>{text}</span>
          <button type="button" class="button small" aria-label="Dismiss" onClick={() => toasts.dismiss(id)}>
            Close
          </button>
        </div>
      ))}
    </div>
  );
}
