// Axes of the bounding box and the triad over the canvas. Frames contain no text (Annotations in protocol/openrpc.json).
// The layout is that of saved pictures (../../wasm/overlay.ts).
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { backgroundColors } from "../../model/background";
import type { Size } from "../../model/camera";
import { layOut, type Overlay } from "../../wasm/overlay";
import { useCamera, useModel } from "../context";

const TEXT_PIXELS = 12;
/** CSS pixels of halo on each side of a letter or a stroke. */
const HALO = 1.5;

function Drawing({ overlay }: { overlay: Overlay }): JSX.Element {
  const { plates, strokes, triangles, labels, halo } = overlay;
  return (
    <>
      {plates.map(({ box, edge, ink }, i) => (
        <rect
          key={`plate ${i}`}
          class="plate"
          x={box.left - edge}
          y={box.top - edge}
          width={box.right - box.left + 2 * edge}
          height={box.bottom - box.top + 2 * edge}
          rx={edge}
          fill={ink}
        />
      ))}
      {strokes.map(({ from, to, width, ink }, i) => (
        <line key={`stroke ${i}`} x1={from.x} y1={from.y} x2={to.x} y2={to.y} stroke={ink} stroke-width={width} />
      ))}
      {triangles.map(({ corners, ink }, i) => (
        <polygon key={`triangle ${i}`} points={corners.map(({ x, y }) => `${x},${y}`).join(" ")} fill={ink} />
      ))}
      {labels.map(({ text, pixels, at, ink }, i) => (
        <text
          key={`label ${i}`}
          x={at.x}
          y={at.y}
          font-size={pixels}
          fill={ink}
          stroke={halo}
          stroke-width={2 * HALO}
          paint-order="stroke"
        >
          {text}
        </text>
      ))}
    </>
  );
}

export function Annotations(): JSX.Element | null {
  const { axes = false, triad = true, scale = 1 } = useModel((model) => model.scene.value?.annotations) ?? {};
  const background = useModel((model) => model.scene.value?.background);
  const description = useModel((model) => model.description.value);
  const taken = useModel((model) => model.taken.value);
  const root = useRef<SVGSVGElement>(null);
  const [size, setSize] = useState<Size | null>(null);
  const camera = useCamera();
  const shown = (axes || triad) && camera !== null && description !== null;
  useEffect(() => {
    const element = root.current;
    if (element === null) return;
    const measure = (): void => setSize({ width: element.clientWidth, height: element.clientHeight });
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, [shown]);
  if (!shown) return null;
  const drawn =
    size === null
      ? null
      : layOut({
          size,
          text: TEXT_PIXELS * scale,
          camera,
          bounds: description.bounds,
          background: backgroundColors(background),
          triad,
          axes,
          lengthUnits: description.length_units,
          taken,
        });
  return (
    <svg class="annotations" ref={root}>
      {drawn !== null && triad && (
        <g class="triad" role="img" aria-label="Directions of x, y and z">
          <Drawing overlay={drawn.triad} />
        </g>
      )}
      {drawn !== null && axes && (
        <g class="box-axes" role="img" aria-label="Axes of the bounding box">
          <Drawing overlay={drawn.axes} />
        </g>
      )}
    </svg>
  );
}
