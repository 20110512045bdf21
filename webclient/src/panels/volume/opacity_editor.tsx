// Editor for a volume's opacity curve, over the histogram of its array.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { formatNumber, valueAt } from "../../model/numbers";
import { MOST_POINTS, inserted, keyedPoint, moved, removed, type OpacityPoint } from "../../model/opacity";
import { useHandleDrag } from "../controls/handle_drag";
import { histogramBars } from "../controls/histogram_bars";
import { OpacityPointFields } from "./opacity_point_fields";

interface Props {
  name: string;
  units: string;
  /** Range of the color scale. Positions from 0 to 1 cover this range. */
  range: Range;
  logarithmic: boolean;
  histogram: Histogram | null;
  points: readonly OpacityPoint[];
  onChange: (points: OpacityPoint[], gesture: string) => void;
  newGesture: () => string;
}

const HEIGHT = 96;

function curve(points: readonly OpacityPoint[]): string {
  const at = ([position, opacity]: readonly number[]): string =>
    `${100 * (position ?? 0)} ${HEIGHT * (1 - (opacity ?? 0))}`;
  const ends = [[0, points[0]?.[1] ?? 0], ...points, [1, points.at(-1)?.[1] ?? 0]];
  return `M${ends.map(at).join("L")}`;
}

interface HandleProps {
  index: number;
  point: OpacityPoint;
  value: string;
  onKeyDown: (event: KeyboardEvent) => void;
  onRemove: () => void;
  onFocus: () => void;
}

function Handle({ index, point: [position, opacity], value, onKeyDown, onRemove, onFocus }: HandleProps): JSX.Element {
  const text = `${Math.round(opacity * 100)} % at ${value}`;
  return (
    <div
      class="opacity-point"
      data-index={index}
      role="slider"
      tabIndex={0}
      aria-label={`Opacity point ${index + 1}`}
      aria-valuemin={0}
      aria-valuemax={1}
      aria-valuenow={opacity}
      aria-valuetext={text}
      title={`${text}. Delete or a double click removes it`}
      style={{ left: `${position * 100}%`, top: `${(1 - opacity) * 100}%` }}
      onKeyDown={onKeyDown}
      onDblClick={onRemove}
      onFocus={onFocus}
    />
  );
}

function Background({ range, logarithmic, histogram, points }: Props): JSX.Element {
  return (
    <svg viewBox={`0 0 100 ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
      <path
        d={histogramBars(histogram, {
          range,
          height: HEIGHT,
          logarithmicCounts: true,
          logarithmicAxis: logarithmic,
        })}
      />
      <path class="curve" d={curve(points)} />
    </svg>
  );
}

function Ends({ range, units }: { range: Range; units: string }): JSX.Element {
  const span = range[1] - range[0];
  return (
    <div class="histogram-ends" aria-hidden="true">
      <span>{formatNumber(range[0], span)}</span>
      <span>{units}</span>
      <span>{formatNumber(range[1], span)}</span>
    </div>
  );
}

/** Returns the points after a key press on the point `index`. Returns null for a key without effect. */
function afterKey(event: KeyboardEvent, points: readonly OpacityPoint[], index: number): OpacityPoint[] | null {
  const point = points[index];
  if (point === undefined) return null;
  const isRemoval = event.key === "Delete" || event.key === "Backspace";
  const to = keyedPoint(event.key, event.shiftKey, point);
  if (to === null && !isRemoval) return null;
  event.preventDefault();
  event.stopPropagation();
  return to === null ? removed(points, index) : moved(points, index, to);
}

export function OpacityEditor(props: Props): JSX.Element {
  const { name, units, range, logarithmic, points, newGesture, onChange } = props;
  const [chosen, setChosen] = useState(0);
  const { track, pointer, keyGesture } = useHandleDrag({
    newGesture,
    pressed: ({ x, y }, gesture) => {
      if (points.length >= MOST_POINTS) return null;
      const [more, index] = inserted(points, [x, y]);
      onChange(more, gesture);
      return index;
    },
    moved: (index, { x, y }, gesture) => onChange(moved(points, index, [x, y]), gesture),
  });
  const onKeyDown = (event: KeyboardEvent, index: number): void => {
    const changed = afterKey(event, points, index);
    if (changed !== null) onChange(changed, keyGesture(event));
  };
  const span = range[1] - range[0];
  const inHand = Math.min(chosen, points.length - 1);
  const inHandPoint = points[inHand];
  const valueOf = (position: number): string =>
    `${formatNumber(valueAt(position, range, logarithmic), logarithmic ? undefined : span)} ${units}`.trim();
  return (
    <div class="histogram">
      <div
        class="histogram-track opacity-track"
        ref={track}
        role="group"
        aria-label={`Opacity over ${name}`}
        {...pointer}
      >
        <Background {...props} />
        {points.map((point, index) => (
          <Handle
            key={index}
            index={index}
            point={point}
            value={valueOf(point[0])}
            onKeyDown={(event) => onKeyDown(event, index)}
            onRemove={() => onChange(removed(points, index), newGesture())}
            onFocus={() => setChosen(index)}
          />
        ))}
      </div>
      <Ends range={range} units={units} />
      {inHandPoint !== undefined && (
        <OpacityPointFields
          index={inHand}
          point={inHandPoint}
          between={[points[inHand - 1]?.[0] ?? 0, points[inHand + 1]?.[0] ?? 1]}
          range={range}
          logarithmic={logarithmic}
          units={units}
          set={(to) => onChange(moved(points, inHand, to), newGesture())}
        />
      )}
    </div>
  );
}
