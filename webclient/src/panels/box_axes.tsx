// The bounding box's ticks and numbers over the canvas: frames carry no writing (Annotations in the contract).
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Size } from "../camera/camera";
import { boxAxes, type BoxAxis } from "../scene/box_axes";
import { useApp, useAppState } from "./context";

const TICK = 6;
const NUMBER_AT = 20;
const NAME_AT = 46;

function Axis({ axis, units }: { axis: BoxAxis; units: string }): JSX.Element {
  const { from, to, outward, ticks } = axis;
  const beside = (x: number, y: number, away: number) => ({ x: x + away * outward.x, y: y + away * outward.y });
  return (
    <g>
      <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
      {ticks.map(({ x, y, label }) => {
        const end = beside(x, y, TICK);
        return (
          <g key={label}>
            <line x1={x} y1={y} x2={end.x} y2={end.y} />
            <text {...beside(x, y, NUMBER_AT)}>{label}</text>
          </g>
        );
      })}
      <text {...beside((from.x + to.x) / 2, (from.y + to.y) / 2, NAME_AT)}>
        {axis.name}
        {units !== "" && ` [${units}]`}
      </text>
    </g>
  );
}

export function BoxAxes(): JSX.Element | null {
  const { actions } = useApp();
  const wanted = useAppState((state) => state.scene?.annotations?.axes === true);
  useAppState((state) => state.scene?.camera);
  const description = useAppState((state) => state.description);
  const root = useRef<SVGSVGElement>(null);
  const [size, setSize] = useState<Size | null>(null);
  useEffect(() => {
    const element = root.current;
    if (element === null) return;
    const measure = (): void => setSize({ width: element.clientWidth, height: element.clientHeight });
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, [wanted]);
  const camera = actions.camera();
  if (!wanted || camera === null || description === null) return null;
  const axes = size === null ? [] : boxAxes(camera, description.bounds, size);
  return (
    <svg class="box-axes" ref={root} role="img" aria-label="Axes of the bounding box">
      {axes.map((axis) => (
        <Axis key={axis.name} axis={axis} units={description.length_units} />
      ))}
    </svg>
  );
}
