// Status bar: latency, frame rate, kind of the shown picture.
import type { JSX } from "preact";
import { isStillDue, openingIn } from "../../model/model";
import type { Readout } from "../../model/state";
import { formatCount } from "../../model/numbers";
import { useModel } from "../context";
import { useLasting } from "../controls/lasting";

const milliseconds = (value: number): string => `${value < 10 ? value.toFixed(1) : value.toFixed(0)} ms`;

/** Zero is "idle", because the server sends frames only when the scene changes. */
const rate = (perSecond: number): string =>
  perSecond === 0 ? "idle" : `${perSecond.toFixed(perSecond < 10 ? 1 : 0)} fps`;

function kind({ stream, still }: Readout): string {
  if (stream === "geometry") return "geometry";
  return still ? "image, still" : "image, preview";
}

/** Milliseconds after which the page reports that a still picture is pending. */
const PATIENCE_MS = 1000;

/** The element stays while it is empty, because screen readers announce only changes of existing elements. */
function StillNotice(): JSX.Element {
  const due = useModel(isStillDue);
  const frame = useModel((model) => model.readout.value.frame);
  const late = useLasting(due, PATIENCE_MS, frame);
  return (
    <span class={late ? "drawing" : ""} role="status" aria-live="polite" data-readout="drawing">
      {late && "full picture is being drawn\u2026"}
    </span>
  );
}

export function StatusBar(): JSX.Element {
  const readout = useModel((model) => model.readout.value);
  const mesh = useModel((model) => model.description.value?.mesh);
  const wanted = useModel((model) => (model.pending.value ? "pending" : model.revision.value));
  const opening = useModel((model) => openingIn(model) !== null);
  const cells = Object.values(mesh?.cells ?? {}).reduce((sum, count) => sum + count, 0);
  return (
    <footer
      class="status-bar"
      data-stream={readout.stream}
      data-still={String(readout.still)}
      data-frame={readout.frame}
      data-revision={readout.revision}
      data-wanted={wanted}
    >
      {mesh !== undefined && !opening && <span>{formatCount(cells)} cells</span>}
      {readout.stream !== "none" && !opening && (
        <>
          <span data-readout="stream">{kind(readout)}</span>
          <StillNotice />
          <span class="dimensions">
            {readout.width} × {readout.height}
          </span>
          <span data-readout="triangles">{formatCount(readout.triangles)} triangles</span>
          <span class="spring" />
          <span class="server-times" title="Extraction, drawing and encoding on the server">
            extract {milliseconds(readout.extractMs)} · draw {milliseconds(readout.drawMs)} · encode{" "}
            {milliseconds(readout.encodeMs)}
          </span>
          {readout.roundTripMs !== null && (
            <span class="round-trip" title="To the server and back">
              round trip {milliseconds(readout.roundTripMs)}
            </span>
          )}
          <span data-readout="latency" title="From the last change to its picture">
            latency {readout.latencyMs === null ? "–" : milliseconds(readout.latencyMs)}
          </span>
          <span data-readout="rate" title="Pictures presented per second">
            {rate(readout.framesPerSecond)}
          </span>
        </>
      )}
    </footer>
  );
}
