// Draws changes of the scene that the shown picture lacks over it, if the newer picture is late. Polygons lag behind
// values only: the page turns them itself.
import type { JSX } from "preact";
import { ahead } from "../../model/ahead";
import { cameraOf } from "../../model/model";
import { useModel } from "../context";
import { useLasting } from "../controls/lasting";

/** Milliseconds of latency above which these changes are drawn. */
const BEHIND_MS = 120;

export function Ahead(): JSX.Element | null {
  const shownScene = useModel((model) => model.shownScene.value);
  const { stream, revision, latencyMs, frame } = useModel((model) => model.readout.value);
  const wanted = useModel((model) => model.scene.value);
  const bounds = useModel((model) => model.description.value?.bounds);
  const size = useModel((model) => model.canvasSize.value);
  const newest = useModel((model) => (model.pending.value ? -1 : model.revision.value));
  const differs = revision > 0 && newest !== revision;
  const isLate = useLasting(differs, BEHIND_MS, frame);
  const shown = differs && (isLate || (latencyMs ?? 0) > BEHIND_MS) ? shownScene : null;
  const camera = useModel(cameraOf);
  if (shown === null || wanted === null || bounds === undefined || camera === null) return null;
  const known = stream === "geometry" ? { ...shown, camera: wanted.camera } : shown;
  const { lines, words } = ahead(known, wanted, camera, bounds, size);
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
