// The bounding box's ticks and numbers over the canvas: frames contain no text (Annotations in the contract).
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Size } from "../../model/camera";
import { prettyUnits } from "../../model/numbers";
import { paperAt } from "../../model/background";
import { boxAxes, boxOf, keptClear, numberPlace, placeNames, TICK, type BoxAxis } from "../../model/box_axes";
import { timesPowerOfTen } from "../../model/ticks";
import { useModel, useCamera } from "../context";

const TEXT_PIXELS = 12;
/** Padding in ems between a text and the edge of its plate. */
const PLATE_ROOM = 0.25;
/** Id of the mask that hides the axes behind other overlays. */
const MASK = "beside-overlays";

interface TextProps {
  at: { x: number; y: number };
  text: string;
  size: Size;
  em: number;
}

/** Text on a plate in the background's color, readable over any picture. */
function BackedText({ at, text, size, em }: TextProps): JSX.Element {
  const background = useModel((model) => model.scene.value?.background);
  const { left, top, right, bottom } = boxOf(at, text, em);
  const room = PLATE_ROOM * em;
  return (
    <>
      <rect
        class="plate"
        x={left - room}
        y={top - room}
        width={right - left + 2 * room}
        height={bottom - top + 2 * room}
        rx={room}
        style={{ fill: paperAt(background, at.y / size.height) }}
      />
      <text {...at}>{text}</text>
    </>
  );
}

function Axis({ axis, size, em }: { axis: BoxAxis; size: Size; em: number }): JSX.Element {
  const { from, to, outward, ticks } = axis;
  return (
    <g mask={`url(#${MASK})`}>
      <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
      {ticks.map(({ x, y, label }) => (
        <g key={label}>
          <line x1={x} y1={y} x2={x + TICK * em * outward.x} y2={y + TICK * em * outward.y} />
          <BackedText at={numberPlace({ x, y }, outward, label, size, em)} text={label} size={size} em={em} />
        </g>
      ))}
    </g>
  );
}

export function BoxAxes(): JSX.Element | null {
  const { axes: wanted = false, scale = 1 } = useModel((model) => model.scene.value?.annotations) ?? {};
  const description = useModel((model) => model.description.value);
  const taken = useModel((model) => model.taken.value);
  const root = useRef<SVGSVGElement>(null);
  const [size, setSize] = useState<Size | null>(null);
  const camera = useCamera();
  const shown = wanted && camera !== null && description !== null;
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
  const em = TEXT_PIXELS * scale;
  const axes = size === null ? [] : keptClear(boxAxes(camera, description.bounds, size, em), size, em, taken);
  const units = prettyUnits(description.length_units);
  const names = axes.map((axis) => `${axis.name}${units === "" ? "" : ` [${units}]`}${timesPowerOfTen(axis.exponent)}`);
  return (
    <svg class="box-axes" style={{ fontSize: `${em}px` }} ref={root} role="img" aria-label="Axes of the bounding box">
      <mask id={MASK} maskUnits="userSpaceOnUse" x="0" y="0" width="100%" height="100%">
        <rect class="shown" width="100%" height="100%" />
        {taken.map(({ left, top, right, bottom }) => (
          <rect key={`${left} ${top}`} x={left} y={top} width={right - left} height={bottom - top} />
        ))}
      </mask>
      {size !== null && axes.map((axis) => <Axis key={axis.name} axis={axis} size={size} em={em} />)}
      {size !== null &&
        placeNames(axes, names, size, em, taken).map((label, i) =>
          label === null ? null : (
            <BackedText key={axes[i]?.name} at={{ x: label.x, y: label.y }} text={label.text} size={size} em={em} />
          ),
        )}
    </svg>
  );
}
