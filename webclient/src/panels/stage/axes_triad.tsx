// Directions of x, y and z in the view.
import type { JSX } from "preact";
import { frame } from "../../model/camera";
import { dot, type Vec3 } from "../../model/vector";
import { useModel, useCamera } from "../context";

const AXES: { name: string; direction: Vec3 }[] = [
  { name: "x", direction: [1, 0, 0] },
  { name: "y", direction: [0, 1, 0] },
  { name: "z", direction: [0, 0, 1] },
];
const ARM = 26;

export function AxesTriad(): JSX.Element | null {
  const wanted = useModel((model) => model.scene.value?.annotations?.triad !== false);
  const scale = useModel((model) => model.scene.value?.annotations?.scale ?? 1);
  useModel((model) => model.description.value);
  const camera = useCamera();
  if (camera === null || !wanted) return null;
  const { right, up, forward } = frame(camera);
  const arms = AXES.map(({ name, direction }) => ({
    name,
    x: dot(direction, right) * ARM,
    y: -dot(direction, up) * ARM,
    depth: dot(direction, forward),
  })).sort((a, b) => b.depth - a.depth);
  return (
    <svg class="triad" style={{ zoom: scale }} viewBox="-40 -40 80 80" role="img" aria-label="Directions of x, y and z">
      {arms.map(({ name, x, y }) => (
        <g key={name} class={`axis-${name}`}>
          <line x1={0} y1={0} x2={x} y2={y} />
          <text x={x * 1.32} y={y * 1.32}>
            {name}
          </text>
        </g>
      ))}
    </svg>
  );
}
