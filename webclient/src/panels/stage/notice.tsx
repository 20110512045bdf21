// Notices that explain why the page shows no picture, or why the shown picture is out of date.
import type { JSX } from "preact";
import { useEffect, useState } from "preact/hooks";
import { openingIn } from "../../model/model";
import type { EmptyLayer, Scene } from "../../generated/protocol";
import { formatCount } from "../../model/numbers";
import { wordsOf } from "../../model/long_call";
import { layerNames } from "../../model/layer_names";
import { layersInOrder } from "../../model/layer_order";
import { useLasting } from "../controls/lasting";
import { TokenForm } from "./token_form";
import { useCommands, useModel } from "../context";

/** Returns the seconds until `at` (Date.now()). Renders the panel again during the countdown. */
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
  const refusal = useModel((model) => model.refusal.value);
  const kept = hasPicture ? "The picture is old. Your scene is kept and comes back with the connection." : "";
  if (!navigator.onLine) return { title: "This computer is offline", words: kept };
  if (refusal?.kind === "refused") return { title: "The server refuses the page", words: refusal.words };
  if (refusal?.kind === "no-socket") {
    return {
      title: "The server answers, but no WebSocket reaches the server",
      words:
        "A proxy between the browser and the server blocks the WebSocket. Configure the proxy to forward WebSocket upgrades on the path ws.",
    };
  }
  const asked = `${location.host} cannot be reached. Is "ciel serve" running there?`;
  return { title: "The server does not answer", words: hasPicture ? kept : asked };
}

export function ConnectionNotice(): JSX.Element | null {
  const commands = useCommands();
  const connection = useModel((model) => model.connection.value);
  const hasPicture = useModel((model) => model.readout.value.stream !== "none");
  const draining = useModel((model) => model.draining.value);
  const needsToken = useModel((model) => model.refusal.value?.kind === "token");
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
      <button type="button" class="button primary" onClick={() => commands.retry()}>
        Try now
      </button>
    </div>
  );
}

const MOST_CHOICES = 6;

function Choices(): JSX.Element | null {
  const commands = useCommands();
  const datasets = useModel((model) => model.datasets.value) ?? [];
  const usable = datasets.filter(({ problem }) => problem === "");
  const more = usable.length - MOST_CHOICES;
  if (usable.length === 0) return null;
  return (
    <>
      <p>Choose a dataset that is here:</p>
      <div class="choices" role="group" aria-label="Datasets that can be opened">
        {usable.slice(0, MOST_CHOICES).map(({ name }) => (
          <button key={name} type="button" class="button" onClick={() => void commands.openDataset(name)}>
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
  const commands = useCommands();
  const fatal = useModel((model) => model.fatal.value);
  const connected = useModel((model) => model.connection.value.kind === "open");
  const keptName = useModel((model) => model.scene.value?.dataset);
  const [trying, setTrying] = useState(false);
  if (fatal === null || !connected) return null;
  const tryAgain = async (): Promise<void> => {
    setTrying(true);
    await commands.reopen();
    setTrying(false);
  };
  return (
    <div class="notice" role="alert">
      <strong>Nothing can be shown</strong>
      <p>{fatal}</p>
      <Choices />
      {keptName !== undefined && <p class="hint">{`Your scene of ${keptName} is kept until another is chosen.`}</p>}
      <button type="button" class="button" disabled={trying} onClick={() => void tryAgain()}>
        {trying ? "Trying again…" : "Try again"}
      </button>
    </div>
  );
}

const UNSEEN = "No visible layer shows anything.";
const EMPTY = "No visible layer meets the data at this time.";

const MOST_REASONS = 3;

/** Returns sentences that say why the picture is empty. Returns [] if a visible layer shows something. */
function reasonsOf(scene: Scene | null, empty: readonly EmptyLayer[]): string[] {
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
  const lacking = useModel((model) => model.lacking.value);
  const reasons = useModel((model) => reasonsOf(model.scene.value, model.empty.value).join("\n"));
  const connected = useModel((model) => model.connection.value.kind === "open");
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

/** Milliseconds after which a late picture is reported to the user. */
const LATE_MS = 400;

function useLate(): boolean {
  const behind = useModel(
    (model) =>
      model.readout.value.stream === "image" &&
      (model.pending.value || model.readout.value.revision < model.revision.value),
  );
  return useLasting(behind, LATE_MS);
}

/** Returns the reason why the picture is out of date; null for a current picture, or without a connection. */
function useDelay(): string | null {
  const connected = useModel((model) => model.connection.value.kind === "open");
  const opening = useModel(openingIn);
  const first = useModel((model) => model.readout.value.stream === "none" && model.fatal.value === null);
  const late = useLate();
  if (!connected) return null;
  if (opening !== null) return `Opening ${opening}`;
  if (first) return "Opening";
  return late ? "Updating" : null;
}

export function Busy(): JSX.Element | null {
  const commands = useCommands();
  const call = useModel((model) => model.longCall.value);
  const words = useDelay();
  if (call !== null)
    return (
      <div class="busy" role="status">
        {wordsOf(call)}
        <button type="button" class="button small" onClick={() => commands.files.cancel()}>
          Cancel
        </button>
      </div>
    );
  if (words === null) return null;
  return (
    <div class="busy" role="status">
      {words}
    </div>
  );
}

export function ToastList(): JSX.Element {
  const commands = useCommands();
  const shown = useModel((model) => model.toasts.value);
  return (
    <div class="toasts" aria-live="polite">
      {shown.map(({ id, kind, text }) => (
        <div key={id} class={`toast ${kind}`} role={kind === "error" ? "alert" : "status"}>
          <span>{text}</span>
          <button
            type="button"
            class="button small"
            aria-label="Close the message"
            onClick={() => commands.dismiss(id)}
          >
            Close
          </button>
        </div>
      ))}
    </div>
  );
}
