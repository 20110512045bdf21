// Axes of the bounding box and the triad over the canvas. The page draws them, because frames contain no text.
import type { JSX } from "preact";
import { DEFAULTS } from "../../generated/protocol";
import { backgroundColors } from "../../model/background";
import { textPixels } from "../../model/canvas_size";
import { layOut } from "../../model/layout";
import { useCamera, useModel } from "../context";
import { Drawing } from "./drawing";

export function Annotations(): JSX.Element | null {
  const given = useModel((model) => model.scene.value?.annotations);
  const { axes, triad, scale } = { ...DEFAULTS.Annotations, ...given };
  const background = useModel((model) => model.scene.value?.background);
  const description = useModel((model) => model.description.value);
  const taken = useModel((model) => model.taken.value);
  const size = useModel((model) => model.canvasSize.value);
  const camera = useCamera();
  if (!(axes || triad) || camera === null || description === null) return null;
  const drawn = layOut({
    size,
    text: textPixels(size) * scale,
    camera,
    bounds: description.bounds,
    background: backgroundColors(background),
    triad,
    axes,
    lengthUnits: description.length_units,
    taken,
  });
  return (
    <svg class="annotations">
      {triad && (
        <g class="triad" role="img" aria-label="Directions of x, y and z">
          <Drawing overlay={drawn.triad} name="triad" />
        </g>
      )}
      {axes && (
        <g class="box-axes" role="img" aria-label="Axes of the bounding box">
          <Drawing overlay={drawn.axes} name="axes" />
        </g>
      )}
    </svg>
  );
}
