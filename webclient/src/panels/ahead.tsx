// While the picture is behind the hand: what the hand wants, over it.
import type { JSX } from "preact";
import { ahead } from "../scene/ahead";
import { useApp, useAppState } from "./context";
import { useLasting } from "./lasting";

/** A picture that is so late is no longer where the hand is. */
const BEHIND_MS = 120;

export function Ahead(): JSX.Element | null {
  const { actions, scenes } = useApp();
  const { stream, revision, latencyMs, frame } = useAppState((state) => state.readout);
  const wanted = useAppState((state) => state.scene);
  const bounds = useAppState((state) => state.description?.bounds);
  const size = useAppState((state) => state.canvasSize);
  const newest = useAppState((state) => (state.pending ? -1 : state.revision));
  const differs = stream === "image" && revision > 0 && newest !== revision;
  const isLate = useLasting(differs, BEHIND_MS, frame);
  const shown = differs && (isLate || (latencyMs ?? 0) > BEHIND_MS) ? scenes.of(revision) : null;
  const camera = actions.camera();
  if (shown === null || wanted === null || bounds === undefined || camera === null) return null;
  const { lines, words } = ahead(shown, wanted, camera, bounds, size);
  if (lines.length + words.length === 0) return null;
  return (
    <svg class="ahead" aria-hidden="true">
      {lines.map((line, i) => (
        <line key={i} {...line} />
      ))}
      {words.map((text, i) => (
        <text key={text} x={size.width / 2} y={28 + 20 * i}>
          {text}
        </text>
      ))}
    </svg>
  );
}
