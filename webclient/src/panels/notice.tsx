// What stands in the way of a live picture, in full sentences.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { openingDataset } from "../app/opening";
import type { AppState } from "../app/state";
import { formatCount } from "../scene/numbers";
import { layerNames } from "../scene/layer_names";
import { layersInOrder } from "../scene/layer_order";
import { useLasting } from "./lasting";
import { TokenForm } from "./token_form";
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

interface Reason {
  title: string;
  words: string;
}

function useReason(hasPicture: boolean): Reason {
  const refusal = useAppState((state) => state.refusal);
  const kept = hasPicture ? "The picture is from before. Your scene is kept and comes back with the connection." : "";
  if (!navigator.onLine) return { title: "This computer is offline", words: kept };
  if (refusal?.kind === "refused") return { title: "The server does not let this page in", words: refusal.words };
  if (refusal?.kind === "no-socket") {
    return {
      title: "The server answers, but no WebSocket reaches it",
      words: "A proxy on the way holds it back: it has to pass the upgrade of ws on to the server.",
    };
  }
  const asked = `${location.host} cannot be reached. Is "ciel serve" running there?`;
  return { title: "The server does not answer", words: hasPicture ? kept : asked };
}

export function ConnectionNotice(): JSX.Element | null {
  const { session } = useApp();
  const connection = useAppState((state) => state.connection);
  const hasPicture = useAppState((state) => state.readout.stream !== "none");
  const draining = useAppState((state) => state.draining);
  const needsToken = useAppState((state) => state.refusal?.kind === "token");
  const { title, words } = useReason(hasPicture);
  const seconds = useCountdown(connection.kind === "waiting" ? connection.retryAt : null);
  if (connection.kind === "open" || connection.kind === "closed") return null;
  if (connection.kind === "connecting" && connection.attempt === 0) return null;
  const when = connection.kind === "connecting" ? "Trying now." : `Next try in ${seconds} s.`;
  if (needsToken && navigator.onLine) return <TokenForm />;
  return (
    <div class={hasPicture ? "banner" : "notice"} role="alert">
      <strong>{title}</strong>
      <p>
        {`${words} ${when}`.trim()}
        {draining && " The server said that it was stopping."}
      </p>
      <button type="button" class="button primary" onClick={() => session.retryNow()}>
        Try now
      </button>
    </div>
  );
}

const MOST_CHOICES = 6;

/** What can be shown instead, a button each. */
function Choices(): JSX.Element | null {
  const { actions } = useApp();
  const datasets = useAppState((state) => state.datasets) ?? [];
  const usable = datasets.filter(({ problem }) => problem === "");
  const more = usable.length - MOST_CHOICES;
  if (usable.length === 0) return null;
  return (
    <>
      <p>Choose a dataset that is here:</p>
      <div class="choices" role="group" aria-label="Datasets that can be opened">
        {usable.slice(0, MOST_CHOICES).map(({ name }) => (
          <button key={name} type="button" class="button" onClick={() => void actions.openDataset(name)}>
            {name}
          </button>
        ))}
      </div>
      {more > 0 && (
        <p class="hint">{`${formatCount(more)} more ${more === 1 ? "is" : "are"} in the list at the top.`}</p>
      )}
    </>
  );
}

export function FatalNotice(): JSX.Element | null {
  const { session } = useApp();
  const fatal = useAppState((state) => state.fatal);
  const connected = useAppState((state) => state.connection.kind === "open");
  const keptName = useAppState((state) => state.scene?.dataset);
  if (fatal === null || !connected) return null;
  return (
    <div class="notice" role="alert">
      <strong>Nothing can be shown</strong>
      <p>{fatal}</p>
      <Choices />
      {keptName !== undefined && <p class="hint">{`Your scene of ${keptName} is kept until another is chosen.`}</p>}
      <button type="button" class="button" onClick={() => void session.open()}>
        Try again
      </button>
    </div>
  );
}

const UNSEEN = "Nothing is seen of the layers that are switched on.";
const EMPTY = "None of the surfaces that are switched on meets the data at this time.";

const MOST_REASONS = 3;

/** Of a picture in which there is nothing at all: what each layer says of it. */
function reasonsOf({ scene, empty }: AppState): string[] {
  const shown = layersInOrder(scene).filter(
    ([, layer]) => layer.visible !== false && layer.type !== "outline" && layer.type !== "clip",
  );
  const reasons = shown.flatMap(([id]) => empty.filter(({ layer }) => layer === id));
  if (reasons.length < shown.length || reasons.length === 0) return [];
  const names = layerNames(scene);
  const sentences = reasons.map(({ layer, reason }) => `${names.get(layer) ?? layer}: ${reason}`);
  return [reasons.every(({ why }) => why === "outside") ? EMPTY : UNSEEN, ...sentences.slice(0, MOST_REASONS)];
}

export function LackingNotice(): JSX.Element | null {
  const lacking = useAppState((state) => state.lacking);
  const reasons = useAppState((state) => reasonsOf(state).join("\n"));
  const connected = useAppState((state) => state.connection.kind === "open");
  const sentences = lacking.length === 0 && reasons !== "" ? reasons.split("\n") : lacking;
  if (sentences.length === 0 || !connected) return null;
  return (
    <div class="lacking" role="status">
      {sentences.map((sentence) => (
        <p key={sentence}>{sentence}</p>
      ))}
    </div>
  );
}

/** A picture that is late this long is said to be. */
const LATE_MS = 400;

/** Whether the picture has lagged behind the scene for a while: what is seen is not what was asked for. */
function useLate(): boolean {
  const behind = useAppState(
    (state) => state.readout.stream === "image" && (state.pending || state.readout.revision < state.revision),
  );
  return useLasting(behind, LATE_MS);
}

export function Busy(): JSX.Element | null {
  const busy = useAppState((state) => state.busy);
  const connected = useAppState((state) => state.connection.kind === "open");
  const opening = useAppState(openingDataset);
  const first = useAppState((state) => state.readout.stream === "none" && state.fatal === null);
  const late = useLate();
  const words =
    busy ??
    (!connected ? null : opening !== null ? `Opening ${opening}` : first ? "Opening" : late ? "Updating" : null);
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
          <button type="button" class="button small" aria-label="Close the message" onClick={() => toasts.dismiss(id)}>
            Close
          </button>
        </div>
      ))}
    </div>
  );
}
