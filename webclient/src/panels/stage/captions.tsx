// Title, dataset and time over the canvas. Frames contain no text (Annotations in protocol/openrpc.json).
import type { JSX } from "preact";
import { paperAt } from "../../model/background";
import { shownTime } from "../../model/scalars";
import { numberAlone } from "../../wasm/numbers_as_text";
import { useModel } from "../context";

export function Captions(): JSX.Element | null {
  const scene = useModel((model) => model.scene.value);
  const description = useModel((model) => model.description.value);
  const { title = "", dataset = false, time = false, scale = 1 } = scene?.annotations ?? {};
  if (scene === null || (title === "" && !dataset && !time)) return null;
  return (
    <div class="captions" style={{ zoom: scale, "--paper": paperAt(scene.background, 0) }}>
      {title !== "" && <h2>{title}</h2>}
      {dataset && <p>{scene.dataset}</p>}
      {time && <p>Time: {numberAlone(shownTime(description, scene))}</p>}
    </div>
  );
}
