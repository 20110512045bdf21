// Iso-values over the histogram of their array: every value is a handle that the hand and the keyboard move.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Histogram } from "../app/state";
import type { Range } from "../generated/protocol";
import { barHeights, clamp, formatNumber, fractionOf, logarithmicStart, niceStep, valueAt } from "../scene/numbers";

interface Props {
  name: string;
  units: string;
  range: Range;
  histogram: Histogram | null;
  logarithmicCounts: boolean;
  logarithmicAxis: boolean;
  values: readonly number[];
  onChange: (index: number, value: number, gesture: string) => void;
  newGesture: () => string;
}

const HEIGHT = 64;

function bars({ histogram, range, logarithmicCounts, logarithmicAxis }: Props): string {
  if (histogram === null) return "";
  const heights = barHeights(histogram.counts, logarithmicCounts);
  const [low, high] = histogram.range;
  const edge = (bin: number): number =>
    100 * fractionOf(low + ((high - low) * bin) / heights.length, range, logarithmicAxis);
  return heights
    .map((height, i) => (height > 0 ? `M${edge(i)} ${HEIGHT}v${-height * (HEIGHT - 4)}H${edge(i + 1)}V${HEIGHT}z` : ""))
    .join("");
}

const KEYS: Record<string, [direction: 1 | -1, reach: "step" | "page" | "end"]> = {
  ArrowRight: [1, "step"],
  ArrowUp: [1, "step"],
  ArrowLeft: [-1, "step"],
  ArrowDown: [-1, "step"],
  PageUp: [1, "page"],
  PageDown: [-1, "page"],
  Home: [-1, "end"],
  End: [1, "end"],
};

/** What a key does to a value; null where it does nothing. On a logarithmic axis a step is a factor. */
export function keyed(key: string, shift: boolean, value: number, range: Range, logarithmic = false): number | null {
  const [low, high] = range;
  const [direction, reach] = KEYS[key] ?? [1, null];
  if (reach === null) return null;
  if (reach === "end") return direction > 0 ? high : low;
  if (logarithmic && logarithmicStart(range) !== null) {
    const part = reach === "page" || shift ? 0.1 : 0.01;
    return valueAt(fractionOf(value, range, true) + direction * part, range, true);
  }
  const step = reach === "page" ? (high - low) / 10 : niceStep(range) * (shift ? 100 : 10);
  return Number(clamp(value + direction * step, low, high).toPrecision(12));
}

export function HistogramSlider(props: Props): JSX.Element {
  const { name, units, range, values, logarithmicAxis, newGesture, onChange } = props;
  const track = useRef<HTMLDivElement>(null);
  const drag = useRef<{ index: number; gesture: string } | null>(null);
  const keyGesture = useRef("");
  const latest = useRef(props);
  useEffect(() => void (latest.current = props));

  const valueUnder = (clientX: number): number => {
    const box = track.current?.getBoundingClientRect();
    return box === undefined ? range[0] : valueAt((clientX - box.left) / box.width, range, logarithmicAxis);
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
    const next = keyed(event.key, event.shiftKey, value, range, logarithmicAxis);
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
          <path d={bars(props)} />
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
            style={{ left: `${fractionOf(value, range, logarithmicAxis) * 100}%` }}
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
