// The opacity curve of a volume over the histogram of its array. A click beside the points makes one; they are dragged,
// moved by the arrow keys, and taken away by Delete or a double click.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Histogram } from "../app/state";
import type { Range } from "../generated/protocol";
import { barHeights, clamp, formatNumber, fractionOf } from "../scene/numbers";
import { MOST_POINTS, inserted, keyedPoint, moved, removed, type OpacityPoint } from "../scene/opacity";

interface Props {
  name: string;
  units: string;
  range: Range;
  histogram: Histogram | null;
  points: readonly OpacityPoint[];
  onChange: (points: OpacityPoint[], gesture: string) => void;
  newGesture: () => string;
}

const HEIGHT = 96;

function bars({ histogram, range }: Props): string {
  if (histogram === null) return "";
  const heights = barHeights(histogram.counts, true);
  const [low, high] = histogram.range;
  const edge = (bin: number): number => 100 * fractionOf(low + ((high - low) * bin) / heights.length, range, false);
  return heights
    .map((height, i) => (height > 0 ? `M${edge(i)} ${HEIGHT}v${-height * (HEIGHT - 4)}H${edge(i + 1)}V${HEIGHT}z` : ""))
    .join("");
}

function curve(points: readonly OpacityPoint[]): string {
  const at = ([position, opacity]: readonly number[]): string =>
    `${100 * (position ?? 0)} ${HEIGHT * (1 - (opacity ?? 0))}`;
  const ends = [[0, points[0]?.[1] ?? 0], ...points, [1, points.at(-1)?.[1] ?? 0]];
  return `M${ends.map(at).join("L")}`;
}

function pointUnder(track: Element | null, event: PointerEvent): OpacityPoint {
  const box = track?.getBoundingClientRect();
  if (box === undefined) return [0, 0];
  return [clamp((event.clientX - box.left) / box.width, 0, 1), clamp(1 - (event.clientY - box.top) / box.height, 0, 1)];
}

interface HandleProps {
  index: number;
  point: OpacityPoint;
  value: string;
  onKeyDown: (event: KeyboardEvent) => void;
  onRemove: () => void;
}

function Handle({ index, point: [position, opacity], value, onKeyDown, onRemove }: HandleProps): JSX.Element {
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
      title={text}
      style={{ left: `${position * 100}%`, top: `${(1 - opacity) * 100}%` }}
      onKeyDown={onKeyDown}
      onDblClick={onRemove}
    />
  );
}

export function OpacityEditor(props: Props): JSX.Element {
  const { name, units, range, points, newGesture, onChange } = props;
  const track = useRef<HTMLDivElement>(null);
  const drag = useRef<{ index: number; gesture: string } | null>(null);
  const keyGesture = useRef("");
  const latest = useRef(props);
  useEffect(() => void (latest.current = props));

  const focus = (index: number): void => track.current?.querySelector<HTMLElement>(`[data-index="${index}"]`)?.focus();
  const onPointerDown = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const handle = (event.target as Element).closest("[data-index]");
    const gesture = newGesture();
    if (handle !== null) {
      drag.current = { index: Number(handle.getAttribute("data-index")), gesture };
    } else if (points.length < MOST_POINTS) {
      const [more, index] = inserted(points, pointUnder(track.current, event));
      drag.current = { index, gesture };
      onChange(more, gesture);
    }
    track.current?.setPointerCapture(event.pointerId);
    event.preventDefault();
    const held = drag.current;
    if (held !== null) requestAnimationFrame(() => focus(held.index));
  };
  const onPointerMove = (event: PointerEvent): void => {
    if (drag.current === null) return;
    const { index, gesture } = drag.current;
    latest.current.onChange(moved(latest.current.points, index, pointUnder(track.current, event)), gesture);
  };
  const onKeyDown = (event: KeyboardEvent, index: number): void => {
    const point = points[index];
    if (point === undefined) return;
    const isRemoval = event.key === "Delete" || event.key === "Backspace";
    const to = keyedPoint(event.key, event.shiftKey, point);
    if (to === null && !isRemoval) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat || keyGesture.current === "") keyGesture.current = newGesture();
    onChange(to === null ? removed(points, index) : moved(points, index, to), keyGesture.current);
  };
  const span = range[1] - range[0];
  const valueOf = (position: number): string => `${formatNumber(range[0] + position * span, span)} ${units}`.trim();
  return (
    <div class="histogram">
      <div
        class="histogram-track opacity-track"
        ref={track}
        role="group"
        aria-label={`Opacity over ${name}`}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={() => (drag.current = null)}
        onPointerCancel={() => (drag.current = null)}
      >
        <svg viewBox={`0 0 100 ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
          <path d={bars(props)} />
          <path class="curve" d={curve(points)} />
        </svg>
        {points.map((point, index) => (
          <Handle
            key={index}
            index={index}
            point={point}
            value={valueOf(point[0])}
            onKeyDown={(event) => onKeyDown(event, index)}
            onRemove={() => onChange(removed(points, index), newGesture())}
          />
        ))}
      </div>
      <div class="histogram-ends" aria-hidden="true">
        <span>{formatNumber(range[0], span)}</span>
        <span>{units}</span>
        <span>{formatNumber(range[1], span)}</span>
      </div>
    </div>
  );
}
