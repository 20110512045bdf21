// Title, dataset and time over the canvas: frames carry no writing (Annotations in the contract).
import type { JSX } from "preact";
import { paperAt } from "../display/background";
import { shownTime } from "../scene/scalars";
import { numberAlone } from "../scene/ticks";
import { useAppState } from "./context";

export function Captions(): JSX.Element | null {
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
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
