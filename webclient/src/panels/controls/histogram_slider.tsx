// Slider for iso-values over the histogram of an array. Each value has a handle, which is moved by pointer or keyboard.
import type { JSX } from "preact";
import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { clamp, formatNumber, fractionOf, logarithmicStart, niceStep, valueAt } from "../../model/numbers";
import { useHandleDrag, type Place } from "./handle_drag";
import { histogramBars } from "./histogram_bars";

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

/** Returns null for keys without effect. On a logarithmic axis, arrow keys multiply the value by a factor. */
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
  const { name, units, range, histogram, values, logarithmicCounts, logarithmicAxis, newGesture, onChange } = props;
  const nearest = (value: number): number =>
    values.reduce((best, v, i) => (Math.abs(v - value) < Math.abs((values[best] ?? Infinity) - value) ? i : best), 0);
  const move = (index: number, { x }: Place, gesture: string): void =>
    onChange(index, valueAt(x, range, logarithmicAxis), gesture);
  const { track, pointer, keyGesture } = useHandleDrag({
    newGesture,
    pressed: (place, gesture) => {
      if (values.length === 0) return null;
      const index = nearest(valueAt(place.x, range, logarithmicAxis));
      move(index, place, gesture);
      return index;
    },
    moved: move,
  });
  const onKeyDown = (event: KeyboardEvent, index: number): void => {
    const value = values[index] ?? range[0];
    const next = keyed(event.key, event.shiftKey, value, range, logarithmicAxis);
    if (next === null) return;
    event.preventDefault();
    event.stopPropagation();
    const gesture = keyGesture(event);
    if (next !== value) onChange(index, next, gesture);
  };
  const span = range[1] - range[0];
  return (
    <div class="histogram">
      <div class="histogram-track" ref={track} {...pointer}>
        <svg viewBox={`0 0 100 ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
          <path d={histogramBars(histogram, { range, height: HEIGHT, logarithmicCounts, logarithmicAxis })} />
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
