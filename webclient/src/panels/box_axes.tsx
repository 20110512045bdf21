// The bounding box's ticks and numbers over the canvas: frames carry no writing (Annotations in the contract).
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Size } from "../camera/camera";
import { prettyUnits } from "../scene/numbers";
import { boxAxes, numberPlace, TICK, type BoxAxis } from "../scene/box_axes";
import { timesPowerOfTen } from "../scene/ticks";
import { useApp, useAppState } from "./context";

const TEXT_PIXELS = 12;

function Axis({ axis, units, em }: { axis: BoxAxis; units: string; em: number }): JSX.Element {
  const { from, to, outward, ticks } = axis;
  const beside = (x: number, y: number, away: number) => ({ x: x + away * outward.x, y: y + away * outward.y });
  const name = `${axis.name}${units === "" ? "" : ` [${units}]`}${timesPowerOfTen(axis.exponent)}`;
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  return (
    <g>
      <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
      {ticks.map(({ x, y, label }) => {
        const end = beside(x, y, TICK * em);
        return (
          <g key={label}>
            <line x1={x} y1={y} x2={end.x} y2={end.y} />
            <text {...numberPlace({ x, y }, outward, label, em)}>{label}</text>
          </g>
        );
      })}
      <text {...numberPlace(beside(middle.x, middle.y, axis.depth - TICK * em), outward, name, em)}>{name}</text>
    </g>
  );
}

export function BoxAxes(): JSX.Element | null {
  const { actions } = useApp();
  const { axes: wanted = false, scale = 1 } = useAppState((state) => state.scene?.annotations) ?? {};
  useAppState((state) => state.scene?.camera);
  const description = useAppState((state) => state.description);
  const root = useRef<SVGSVGElement>(null);
  const [size, setSize] = useState<Size | null>(null);
  const camera = actions.camera();
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
  const axes = size === null ? [] : boxAxes(camera, description.bounds, size, em);
  return (
    <svg class="box-axes" style={{ fontSize: `${em}px` }} ref={root} role="img" aria-label="Axes of the bounding box">
      {axes.map((axis) => (
        <Axis key={axis.name} axis={axis} units={prettyUnits(description.length_units)} em={em} />
      ))}
    </svg>
  );
}
