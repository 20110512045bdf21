// Draws changes of the scene over the shown picture if a picture with these changes is late. Polygons never have a late
// camera, because the page draws them with the newest camera.
import type { JSX } from "preact";
import type { Scene } from "../../generated/protocol";
import { ahead } from "../../model/ahead";
import { cameraOf } from "../../model/model";
import { useModel } from "../context";
import { useLasting } from "../controls/lasting";

/** Latency in ms above which the page draws changes ahead of the picture. */
const BEHIND_MS = 120;

/** A separate component, because it is rendered again at each move of the camera. */
function Drawn({ known }: { known: Scene }): JSX.Element | null {
  const wanted = useModel((model) => model.scene.value);
  const stream = useModel((model) => model.readout.value.stream);
  const bounds = useModel((model) => model.description.value?.bounds);
  const size = useModel((model) => model.canvasSize.value);
  const camera = useModel(cameraOf);
  if (wanted === null || bounds === undefined || camera === null) return null;
  const shown = stream === "geometry" ? { ...known, camera: wanted.camera } : known;
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

export function Ahead(): JSX.Element | null {
  const shownScene = useModel((model) => model.shownScene.value);
  const { revision, latencyMs, frame } = useModel((model) => model.readout.value);
  const newest = useModel((model) => (model.pending.value ? -1 : model.revision.value));
  const differs = revision > 0 && newest !== revision;
  const isLate = useLasting(differs, BEHIND_MS, frame);
  const isDrawn = differs && (isLate || (latencyMs ?? 0) > BEHIND_MS);
  return isDrawn && shownScene !== null ? <Drawn known={shownScene} /> : null;
}
