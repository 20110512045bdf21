// Iso-values over the histogram of their array: every value is a handle that the hand and the keyboard move.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Histogram } from "../app/state";
import type { Range } from "../generated/protocol";
import { barHeights, clamp, formatNumber, fractionOf, niceStep, valueAt } from "../scene/numbers";

interface Props {
  name: string;
  units: string;
  range: Range;
  histogram: Histogram | null;
  logarithmic: boolean;
  values: readonly number[];
  onChange: (index: number, value: number, gesture: string) => void;
  newGesture: () => string;
}

const HEIGHT = 64;

function bars(histogram: Histogram | null, logarithmic: boolean): string {
  if (histogram === null) return "";
  const heights = barHeights(histogram.counts, logarithmic);
  const width = 100 / heights.length;
  return heights
    .map((height, i) => (height > 0 ? `M${i * width} ${HEIGHT}v${-height * (HEIGHT - 4)}h${width}V${HEIGHT}z` : ""))
    .join("");
}

/** What a key does to a value; null where it does nothing. */
export function keyed(key: string, shift: boolean, value: number, range: Range): number | null {
  const step = niceStep(range) * (shift ? 100 : 10);
  const page = (range[1] - range[0]) / 10;
  const moves: Record<string, number> = {
    ArrowRight: value + step,
    ArrowUp: value + step,
    ArrowLeft: value - step,
    ArrowDown: value - step,
    PageUp: value + page,
    PageDown: value - page,
    Home: range[0],
    End: range[1],
  };
  const next = moves[key];
  return next === undefined ? null : Number(clamp(next, range[0], range[1]).toPrecision(12));
}

export function HistogramSlider(props: Props): JSX.Element {
  const { name, units, range, values, newGesture, onChange } = props;
  const track = useRef<HTMLDivElement>(null);
  const drag = useRef<{ index: number; gesture: string } | null>(null);
  const keyGesture = useRef("");
  const latest = useRef(props);
  useEffect(() => void (latest.current = props));

  const valueUnder = (clientX: number): number => {
    const box = track.current?.getBoundingClientRect();
    return box === undefined ? range[0] : valueAt((clientX - box.left) / box.width, range);
  };
  const nearest = (value: number): number =>
    values.reduce((best, v, i) => (Math.abs(v - value) < Math.abs((values[best] ?? Infinity) - value) ? i : best), 0);

  const onPointerDown = (event: PointerEvent): void => {
    if (event.button !== 0 || values.length === 0) return;
    const handle = (event.target as Element).closest("[data-index]");
    const value = valueUnder(event.clientX);
    const index = handle === null ? nearest(value) : Number(handle.getAttribute("data-index"));
    drag.current = { index, gesture: newGesture() };
    track.current?.setPointerCapture(event.pointerId);
    track.current?.querySelector<HTMLElement>(`[data-index="${index}"]`)?.focus();
    event.preventDefault();
    if (handle === null) onChange(index, value, drag.current.gesture);
  };
  const onPointerMove = (event: PointerEvent): void => {
    if (drag.current !== null)
      latest.current.onChange(drag.current.index, valueUnder(event.clientX), drag.current.gesture);
  };
  const onKeyDown = (event: KeyboardEvent, index: number): void => {
    const value = values[index] ?? range[0];
    const next = keyed(event.key, event.shiftKey, value, range);
    if (next === null) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat || keyGesture.current === "") keyGesture.current = newGesture();
    if (next !== value) onChange(index, next, keyGesture.current);
  };
  const span = range[1] - range[0];
  return (
    <div class="histogram">
      <div
        class="histogram-track"
        ref={track}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={() => (drag.current = null)}
        onPointerCancel={() => (drag.current = null)}
      >
        <svg viewBox={`0 0 100 ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
          <path d={bars(props.histogram, props.logarithmic)} />
        </svg>
        {values.map((value, index) => (
          <div
            key={index}
            class="handle"
            data-index={index}
            role="slider"
            tabIndex={0}
            aria-label={values.length > 1 ? `${name}, value ${index + 1}` : `${name}, iso-value`}
            aria-valuemin={range[0]}
            aria-valuemax={range[1]}
            aria-valuenow={value}
            aria-valuetext={`${formatNumber(value, span)} ${units}`.trim()}
            style={{ left: `${fractionOf(value, range) * 100}%` }}
            onKeyDown={(event) => onKeyDown(event, index)}
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
