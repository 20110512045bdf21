// Title, dataset and time over the canvas: frames carry no writing (Annotations in the contract).
import type { JSX } from "preact";
import { formatNumber } from "../scene/numbers";
import { shownTime } from "../scene/scalars";
import { useAppState } from "./context";

export function Captions(): JSX.Element | null {
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  const { title = "", dataset = false, time = false } = scene?.annotations ?? {};
  if (scene === null || (title === "" && !dataset && !time)) return null;
  return (
    <div class="captions">
      {title !== "" && <h2>{title}</h2>}
      {dataset && <p>{scene.dataset}</p>}
      {time && <p>Time: {formatNumber(shownTime(description, scene))}</p>}
    </div>
  );
}
