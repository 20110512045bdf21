// Position of a plane perpendicular to an axis: a slider over the dataset's bounds, and a number field.
import type { JSX } from "preact";
import { endsOf, type Axis } from "../../model/axes";
import { clamp, formatNumber, sliderTrack } from "../../model/numbers";
import { NumberField, Slider } from "../controls/controls";
import { useCommands, useModel } from "../context";

interface PositionProps {
  id: string;
  axis: Axis;
  /** Coordinate of the plane along the axis. undefined: the middle of the bounds. */
  value: number | undefined;
  /** Accessible names of the slider and of the number field. */
  labels: readonly [string, string];
}

export function PositionRow({ id, axis, value, labels }: PositionProps): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const [low, high] = description === null ? [0, 1] : endsOf(axis, description.bounds);
  const position = value ?? (low + high) / 2;
  const set = (to: number, gesture?: string): void => commands.layers.set(id, { value: to }, gesture);
  return (
    <div class="clip-row">
      <Slider
        label={labels[0]}
        {...sliderTrack([low, high])}
        value={position}
        text={`${formatNumber(position, high - low)} ${description?.length_units ?? ""}`.trim()}
        newGesture={() => commands.newGesture()}
        onChange={(to, gesture) => set(clamp(to, low, high), gesture)}
      />
      <NumberField label={labels[1]} value={position} span={high - low} onChange={set} />
    </div>
  );
}
