// Colour bars over the canvas, one per colouring in use; the range is edited in place.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { colorMap, DEFAULT_MAP } from "../display/color_maps";
import type { Coloring, Range } from "../generated/protocol";
import type { Size } from "../camera/camera";
import { formatNumber, fractionOf, ticks } from "../scene/numbers";
import { legendsOf, rangeOfAllSteps, shownTime, unitsOf } from "../scene/scalars";
import { IconButton, NumberField } from "./controls";
import { useApp, useAppState } from "./context";

/** Pixels between the box and a legend. */
const ROOM: Size = { width: 12, height: 20 };

function ColorBar({ map }: { map: string }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    const rows = new Uint32Array(Uint8Array.from(colorMap(map)).buffer).reverse(); // the highest on top
    context?.putImageData(new ImageData(new Uint8ClampedArray(rows.buffer), 1, rows.length), 0, 0);
  }, [map]);
  return <canvas ref={canvas} class="color-bar" width={1} height={256} aria-hidden="true" />;
}

interface Entry {
  coloring: Coloring & { array: string };
  layers: string[];
}

function ColorScale({ coloring, layers, range }: Entry & { range: Range }): JSX.Element {
  const { actions } = useApp();
  const span = range[1] - range[0];
  const setRange = (low: number, high: number): void =>
    actions.setColoring(layers, { range: low <= high ? [low, high] : [high, low] });
  return (
    <div class="color-scale">
      <NumberField
        label={`Highest value of the ${coloring.array} colours`}
        value={range[1]}
        span={span}
        onChange={(high) => setRange(range[0], high)}
      />
      <div class="ticks" aria-hidden="true">
        {ticks(range)
          .map((value) => ({ value, at: fractionOf(value, range) }))
          .filter(({ at }) => at > 0.12 && at < 0.88)
          .map(({ value, at }) => (
            <span key={value} style={{ bottom: `${at * 100}%` }}>
              {formatNumber(value, span)}
            </span>
          ))}
      </div>
      <NumberField
        label={`Lowest value of the ${coloring.array} colours`}
        value={range[0]}
        span={span}
        onChange={(low) => setRange(low, range[1])}
      />
    </div>
  );
}

/** Of an array that has one value: a scale of it would say the same thrice. */
function OneValue({ value }: { value: number }): JSX.Element {
  return (
    <p class="one-value">
      {formatNumber(value)}
      <small>everywhere</small>
    </p>
  );
}

function RangeButtons({ coloring, layers, range }: Entry & { range: Range }): JSX.Element {
  const { actions } = useApp();
  const description = useAppState((state) => state.description);
  const set = (to: Range | undefined): void => actions.setColoring(layers, { range: to });
  const reach = Math.max(-range[0], range[1]);
  const name = coloring.array;
  return (
    <div class="range-buttons">
      {coloring.range && (
        <IconButton icon="reset" label={`Range of the data for ${name}`} onClick={() => set(undefined)} />
      )}
      {!coloring.range && (description?.times.length ?? 0) > 1 && (
        <IconButton
          icon="hold"
          label={`The same range at every step for ${name}`}
          onClick={() => set(rangeOfAllSteps(description, name) ?? range)}
        />
      )}
      {range[0] < 0 && range[1] > 0 && range[0] !== -range[1] && (
        <IconButton
          icon="symmetric"
          label={`Range symmetric about zero for ${name}`}
          onClick={() => set([-reach, reach])}
        />
      )}
    </div>
  );
}

function LegendEntry({ coloring, layers }: Entry): JSX.Element {
  const { histograms } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  useAppState((state) => state.histogramsAt);
  const units = unitsOf(description, coloring.array);
  const [head, ...tail] = coloring.array.split(":"); // a long name is broken where its component begins
  const own =
    description === null ? null : histograms.get(description.name, coloring.array, shownTime(description, scene));
  const range: Range | null = coloring.range ?? own?.range ?? null;
  const constant = !coloring.range && range !== null && range[0] === range[1];
  return (
    <figure class="legend" aria-label={`Colours of ${coloring.array}`}>
      <figcaption>
        {head}
        {tail.map((part) => [":", <wbr key={part} />, part])}
        {units !== "" && <small> {units}</small>}
      </figcaption>
      <div class="legend-scale">
        <ColorBar map={coloring.map ?? DEFAULT_MAP} />
        {range !== null &&
          (constant ? <OneValue value={range[0]} /> : <ColorScale coloring={coloring} layers={layers} range={range} />)}
      </div>
      {range !== null && <RangeButtons coloring={coloring} layers={layers} range={range} />}
    </figure>
  );
}

/** From the stage's top right corner to the far ends of the legends, with room around them. */
function cornerOf(legends: HTMLElement): Size {
  const stage = legends.parentElement?.getBoundingClientRect();
  const boxes = [...legends.children].map((child) => child.getBoundingClientRect());
  if (stage === undefined || boxes.length === 0) return { width: 0, height: 0 };
  const left = Math.min(...boxes.map((box) => box.left));
  const bottom = Math.max(...boxes.map((box) => box.bottom));
  return { width: stage.right - left + ROOM.width, height: bottom - stage.top + ROOM.height };
}

export function Legends(): JSX.Element | null {
  const { size } = useApp();
  const scene = useAppState((state) => state.scene);
  const entries = scene?.annotations?.legend === false ? [] : legendsOf(scene);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = root.current;
    if (element === null) return;
    const measure = (): void => void (size.corner = cornerOf(element));
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, [size]);
  return (
    <div class="legends" ref={root}>
      {entries.map((entry) => (
        <LegendEntry key={`${entry.coloring.array} ${entry.coloring.map ?? ""} ${entry.layers.join(" ")}`} {...entry} />
      ))}
    </div>
  );
}
