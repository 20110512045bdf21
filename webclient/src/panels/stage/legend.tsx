// Legends over the canvas: a color bar for each color scale in use. The user can edit its range there.
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { colorsAlong, hasWidth, type ColorScale } from "../../model/color_scale";
import { barHeight, legendText } from "../../model/overlay_room";
import type { Range } from "../../generated/protocol";
import type { Size } from "../../model/camera";
import { withDataRange, withRangeEnd, type ColoringChange } from "../../model/color_edit";
import { rangeOf, scaleOf } from "../../model/color_range";
import { equal } from "../../model/merge_patch";
import { colorTicks, exponentOf, labelOn, type ColorTick } from "../../wasm/color_ticks";
import { clamp, formatNumber } from "../../model/numbers";
import { cellsText, extremesText } from "../../model/cell_extremes";
import {
  arrayOf,
  legendsOf,
  rangeOfAllSteps,
  unitsOf,
  type Colored,
  type LegendOf,
  type ScaledColoring,
} from "../../model/scalars";
import { legendTitle } from "../../model/legend_names";
import { IconButton, NumberField } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { useDataRange } from "../color/data_range";

const BAR_PIXELS = 256;

/** CSS pixels kept free between the bounding box and a legend. */
const ROOM: Size = { width: 12, height: 20 };

/** Color bar of a legend. Triangles beyond its ends show the colors of values outside the range. */
function ColorBar({ scale }: { scale: ColorScale }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  const key = JSON.stringify(scale);
  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    const pixels = colorsAlong(scale, BAR_PIXELS).reverse(); // highest value on top
    const rgba = Uint8ClampedArray.from(pixels.flatMap((color) => [...color, 255]));
    context?.putImageData(new ImageData(rgba, 1, BAR_PIXELS), 0, 0);
  }, [key]);
  return (
    <div class="color-bar">
      {scale.above !== null && <span class="color-end" title="Above the range" style={{ background: scale.above }} />}
      <canvas ref={canvas} class={scale.steps > 1 ? "stepped" : ""} width={1} height={BAR_PIXELS} aria-hidden="true" />
      {scale.below !== null && (
        <span class="color-end below" title="Below the range" style={{ background: scale.below }} />
      )}
    </div>
  );
}

const LINE_PIXELS = 14;
const USUAL_HEIGHT = 120;
const LINES_APART = 1.7;
const MOST_TICKS = 6;
/** Smallest distance between marks in CSS pixels. Closer marks would look like one. */
const MARKS_APART = 4;

/** Ticks between the two ends of the bar, without those whose labels would overlap another label. */
function spacedTicks(scale: ColorScale, height: number): ColorTick[] {
  const gap = LINE_PIXELS / height;
  let last = 0;
  const most = clamp(Math.floor(height / (LINES_APART * LINE_PIXELS)), 1, MOST_TICKS);
  return colorTicks(scale, most, 1 + Math.floor(height / MARKS_APART)).filter((tick) => {
    if (tick.label === "") return true;
    if (tick.at - last < gap || tick.at > 1 - gap) return false;
    last = tick.at;
    return true;
  });
}

interface Entry {
  coloring: ScaledColoring;
  of: Colored;
}

/** Text size in CSS pixels at which a line is LINE_PIXELS high. */
const USUAL_TEXT = 12;
/** Additional width in digits, because a minus sign is wider than a digit. */
const BESIDE_DIGITS = 0.5;

interface ScaleProps extends Entry {
  scale: ColorScale;
  range: Range;
  text: number;
}

function LegendScale({ coloring, of, scale, range, text }: ScaleProps): JSX.Element {
  const commands = useCommands();
  const along = useRef<HTMLDivElement>(null);
  const [height, setHeight] = useState(USUAL_HEIGHT);
  useEffect(() => {
    const element = along.current;
    if (element === null) return;
    const observer = new ResizeObserver(() => setHeight(element.clientHeight));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const span = scale.log ? undefined : range[1] - range[0];
  const shown = (value: number): string => labelOn(scale, value);
  const setEnd = (end: 0 | 1, to: number): void => {
    const change = withRangeEnd(coloring, range, end, to);
    if (typeof change === "string") commands.tell(change, "error");
    else commands.colors.set(of, change);
  };
  const ticks = spacedTicks(scale, (height * USUAL_TEXT) / text);
  const digits = Math.max(...[...range.map(shown), ...ticks.map(({ label }) => label)].map(({ length }) => length));
  return (
    <div class="color-scale" style={{ "--digits": `${digits + BESIDE_DIGITS}ch` }}>
      <NumberField
        label={`Highest value of the ${coloring.array} colors`}
        help="The upper end of the colors. Type another to hold it"
        value={range[1]}
        span={span}
        shown={shown}
        onChange={(high) => setEnd(1, high)}
      />
      <div class="ticks" ref={along} aria-hidden="true">
        {ticks.map(({ value, at, label }) => (
          <span key={value} class={label === "" ? "mark" : ""} style={{ bottom: `${at * 100}%` }}>
            {label}
          </span>
        ))}
      </div>
      <NumberField
        label={`Lowest value of the ${coloring.array} colors`}
        help="The lower end of the colors. Type another to hold it"
        value={range[0]}
        span={span}
        shown={shown}
        onChange={(low) => setEnd(0, low)}
      />
    </div>
  );
}

/** Shown instead of a color bar for a constant array. A bar would have the same number three times. */
function OneValue({ value }: { value: number }): JSX.Element {
  return (
    <p class="one-value">
      {formatNumber(value)}
      <small>everywhere</small>
    </p>
  );
}

/** Where the range comes from: data of this step, data of all steps, or chosen by the user ("held"). */
function rangeWords(coloring: ScaledColoring, everywhere: Range | null): string {
  if (!coloring.range) return "this step";
  const ofAll = everywhere === null ? "" : withDataRange(coloring, everywhere);
  return typeof ofAll === "object" && equal(ofAll.range, coloring.range) ? "all steps" : "held";
}

function RangeButtons({ coloring, of, range }: Entry & { range: Range }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const set = (change: ColoringChange | string): void => {
    if (typeof change === "string") commands.tell(change, "error");
    else commands.colors.set(of, change);
  };
  const reach = Math.max(-range[0], range[1]);
  const name = coloring.array;
  const hasSteps = (description?.times.length ?? 0) > 1;
  const everywhere = rangeOfAllSteps(description, name);
  return (
    <div class="range-buttons">
      {coloring.range && (
        <IconButton
          icon="reset"
          label={`Range of the data for ${name}`}
          help="The ends are held. Follow the lowest and the highest value of each step again"
          onClick={() => set({ range: undefined })}
        />
      )}
      {!coloring.range && hasSteps && (
        <IconButton
          icon="hold"
          label={`The same range at every step for ${name}`}
          help={`The ends are the lowest and the highest value of this step. Hold the range of ${everywhere === null ? "this step" : "the whole dataset"} at every step`}
          onClick={() => set(withDataRange(coloring, everywhere ?? range))}
        />
      )}
      {range[0] < 0 && range[1] > 0 && range[0] !== -range[1] && (
        <IconButton
          icon="symmetric"
          label={`Range symmetric about zero for ${name}`}
          onClick={() => set({ range: [-reach, reach] })}
        />
      )}
      {(hasSteps || coloring.range) && <small class="range-of">{rangeWords(coloring, everywhere)}</small>}
    </div>
  );
}

function LegendEntry({ coloring, of, name, text }: LegendOf & { text: number }): JSX.Element {
  const description = useModel((model) => model.description.value);
  const missing = useModel((model) => model.missing.value);
  const units = unitsOf(description, coloring.array);
  const array = arrayOf(description, coloring.array);
  const data = useDataRange(coloring.array);
  const known = data?.range ?? coloring.range ?? null;
  const range = known === null ? null : rangeOf(coloring, known);
  const scale = scaleOf(coloring, known ?? [0, 1]);
  const constant = range !== null && !hasWidth(scale) && !coloring.range;
  const title = legendTitle(coloring.array, units, range === null || constant ? 0 : exponentOf(scale));
  return (
    <figure class="legend" aria-label={`Colors of ${coloring.array}${name === "" ? "" : `, ${name}`}`}>
      <figcaption>
        <span class="legend-title" title={title}>
          {title}
        </span>
        {name !== "" && <small class="legend-of">{name}</small>}
        {data?.cells !== undefined && array?.association === "point" && (
          <small class="legend-of" title={extremesText(data.cells)}>
            {cellsText(data.cells)}
          </small>
        )}
      </figcaption>
      <div class="legend-scale">
        <ColorBar scale={scale} />
        {range !== null &&
          (constant ? (
            <OneValue value={range[0]} />
          ) : (
            <LegendScale coloring={coloring} of={of} scale={scale} range={range} text={text} />
          ))}
      </div>
      {of.layers.some((layer) => missing.includes(layer)) && (
        <p class="missing">
          <span style={{ background: scale.nan }} /> no value
        </p>
      )}
      {range !== null && <RangeButtons coloring={coloring} of={of} range={range} />}
    </figure>
  );
}

/**
 * For each legend, the size of the rectangle from the stage's top right corner to the legend's far corner, plus ROOM.
 */
function cornerOf(legends: HTMLElement): Size[] {
  const stage = legends.parentElement?.getBoundingClientRect();
  const boxes = [...legends.children].map((child) => child.getBoundingClientRect());
  if (stage === undefined) return [];
  return boxes.map(({ left, bottom }) => ({
    width: stage.right - left + ROOM.width,
    height: bottom - stage.top + ROOM.height,
  }));
}

export function Legends(): JSX.Element | null {
  const commands = useCommands();
  const scene = useModel((model) => model.scene.value);
  const empty = useModel((model) => model.empty.value);
  const description = useModel((model) => model.description.value);
  const entries = scene?.annotations?.legend === false ? [] : legendsOf(scene, description, empty);
  const stage = useModel((model) => model.canvasSize.value);
  const zoom = scene?.annotations?.scale ?? 1;
  const text = legendText(stage);
  const bar = barHeight({ width: stage.width / zoom, height: stage.height / zoom }, entries.length, text);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = root.current;
    if (element === null) return;
    const measure = (): void => commands.page.legendsStand(cornerOf(element));
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, [commands]);
  return (
    <div class="legends" ref={root} style={{ zoom, fontSize: `${text}px`, "--bar": `${bar}px` }}>
      {entries.map((entry) => (
        <LegendEntry key={JSON.stringify([entry.coloring.array, entry.of])} {...entry} text={text} />
      ))}
    </div>
  );
}
