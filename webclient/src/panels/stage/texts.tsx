// Title, captions and legends over the canvas. The page draws these texts, because frames contain no text.
import type { JSX } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { backgroundColors } from "../../model/background";
import { SMALLEST_TEXT, textPixels } from "../../model/canvas_size";
import { hasWidth, inBytes, rangeOf, scaleOf, type ColorScale } from "../../model/color_scale";
import { DEFAULTS, type Range } from "../../generated/protocol";
import type { Size } from "../../model/camera";
import type { Histogram } from "../../model/state";
import { withDataRange, withRangeEnd, type ColoringChange } from "../../model/color_edit";
import { equal } from "../../model/merge_patch";
import {
  labelOn,
  layTexts,
  legendTitle,
  numberAlone,
  type Box,
  type LegendText,
  type Overlay,
} from "../../model/layout";
import { cellsText, extremesText } from "../../model/cell_extremes";
import { arrayOf, legendsOf, rangeOfAllSteps, unitsOf, type LegendOf } from "../../model/scalars";
import { IconButton, NumberField } from "../controls/controls";
import { useCommands, useLayers, useModel, useShownTime } from "../context";
import { Drawing } from "./drawing";

/** CSS pixels kept free between the bounding box and a legend. */
const ROOM: Size = { width: 12, height: 20 };

/** Side of a legend's button, and width of the words beside the buttons, in CSS pixels. */
const BUTTON = 26;
const WORDS = 62;
/** Up to this width of the stage in CSS pixels, controls appear only beside the legend that has pointer or focus. */
const NARROW = 560;

interface Entry extends LegendOf {
  range: Range;
  scale: ColorScale;
  /** Tooltip of the legend: the title, and facts about the values of the array. */
  about: string;
  lines: string[];
}

interface Entries {
  /** Legends of the scene whose range is known. */
  entries: Entry[];
  complete: boolean;
}

/** After a change of the time step, a legend keeps the previous range until the range of the new step has arrived. */
function useEntries(): Entries {
  const before = useRef(new Map<string, Histogram>());
  const commands = useCommands();
  const layers = useLayers();
  const time = useShownTime();
  const hidden = useModel((model) => model.scene.value?.annotations?.legend === false);
  const empty = useModel((model) => model.empty.value);
  const description = useModel((model) => model.description.value);
  if (description === null || hidden) return { entries: [], complete: description !== null };
  const legends = legendsOf(layers, description, empty);
  const entries = legends.flatMap((legend) => {
    const { coloring } = legend;
    const key = JSON.stringify([description.name, coloring.array]);
    const arrived = commands.histogram(description.name, coloring.array, time);
    if (arrived !== null) before.current.set(key, arrived);
    const data = arrived ?? before.current.get(key);
    const known = data?.range ?? coloring.range ?? null;
    if (known === null) return [];
    const range = rangeOf(coloring, known);
    const scale = scaleOf(coloring, known);
    const title = legendTitle(coloring.array, unitsOf(description, coloring.array), scale);
    const cells = arrayOf(description, coloring.array)?.association === "point" ? data?.cells : undefined;
    const constant = !hasWidth(scale) && !coloring.range;
    const about = [title];
    if (constant) about.push(`${labelOn(scale, range[0])} everywhere`);
    if (cells !== undefined) about.push(extremesText(cells));
    return {
      ...legend,
      range,
      scale,
      about: about.join(". "),
      lines: [...(cells === undefined ? [] : [cellsText(cells)]), ...(constant ? ["the same everywhere"] : [])],
    };
  });
  return { entries, complete: entries.length === legends.length };
}

/** Returns the source of the range in words: the data of this step, the data of all steps, or the user ("held"). */
function rangeWords({ coloring }: Entry, everywhere: Range | null): string {
  if (!coloring.range) return "this step";
  const ofAll = everywhere === null ? "" : withDataRange(coloring, everywhere);
  return typeof ofAll === "object" && equal(ofAll.range, coloring.range) ? "all steps" : "held";
}

const isAskew = ([low, high]: Range): boolean => low < 0 && high > 0 && low !== -high;

function controlsOf({ coloring, range }: Entry, hasSteps: boolean, zoom: number): Size {
  const tellsRange = hasSteps || coloring.range !== undefined;
  const buttons = (tellsRange ? 1 : 0) + (isAskew(range) ? 1 : 0);
  return {
    width: zoom * (buttons * BUTTON + (tellsRange ? WORDS : 0)),
    height: buttons === 0 ? 0 : zoom * BUTTON,
  };
}

function RangeButtons({ entry }: { entry: Entry }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const { coloring, of, range } = entry;
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
      {isAskew(range) && (
        <IconButton
          icon="symmetric"
          label={`Range symmetric about zero for ${name}`}
          onClick={() => set({ range: [-reach, reach] })}
        />
      )}
      {(hasSteps || coloring.range) && <small class="range-of">{rangeWords(entry, everywhere)}</small>}
    </div>
  );
}

const ORIGIN: Box = { left: 0, top: 0, right: 0, bottom: 0 };

/** Places an element over a box. `around`: box of the parent element. */
const on = (
  box: Box,
  around = ORIGIN,
  more: Record<string, string | number> = {},
): Record<string, string | number> => ({
  left: `${box.left - around.left}px`,
  top: `${box.top - around.top}px`,
  width: `${box.right - box.left}px`,
  height: `${box.bottom - box.top}px`,
  ...more,
});

/** The overlay draws the number. The field's text is visible only while the field has the pointer or the focus. */
function EndField({
  entry,
  end,
  style,
}: {
  entry: Entry;
  end: 0 | 1;
  style: Record<string, string | number>;
}): JSX.Element {
  const commands = useCommands();
  const { coloring, of, range, scale } = entry;
  const change = (to: number): void => {
    const changed = withRangeEnd(coloring, range, end, to);
    if (typeof changed === "string") commands.tell(changed, "error");
    else commands.colors.set(of, changed);
  };
  return (
    <span class="legend-end" style={style}>
      <NumberField
        label={`${end === 0 ? "Lowest" : "Highest"} value of the ${coloring.array} colors`}
        help={`The ${end === 0 ? "lower" : "upper"} end of the colors. Type another to hold it`}
        value={range[end]}
        span={scale.log ? undefined : range[1] - range[0]}
        shown={(value) => labelOn(scale, value)}
        onChange={change}
      />
    </span>
  );
}

interface LegendProps {
  entry: Entry;
  /** Returns the box of a handle of this legend; undefined if the legend has no such handle. */
  boxOf: (part: string) => Box | undefined;
  text: number;
  zoom: number;
  /** Whether the controls are visible only while the legend has the pointer or the focus. */
  floats: boolean;
}

function Legend({ entry, boxOf, text, zoom, floats }: LegendProps): JSX.Element | null {
  const [all, low, high, controls] = [boxOf(""), boxOf(" low"), boxOf(" high"), boxOf(" controls")];
  if (all === undefined) return null;
  const { coloring, name, about } = entry;
  return (
    <figure
      class="legend"
      style={on(all, undefined, { fontSize: `${text}px` })}
      title={about}
      aria-label={`Colors of ${coloring.array}${name === "" ? "" : `, ${name}`}`}
      tabIndex={floats ? 0 : undefined}
    >
      {high && <EndField entry={entry} end={1} style={on(high, all)} />}
      {low && <EndField entry={entry} end={0} style={on(low, all)} />}
      {(floats || controls) && (
        <div
          class={floats ? "legend-controls floating" : "legend-controls"}
          style={controls === undefined ? { "--zoom": zoom } : on(controls, all, { "--zoom": zoom })}
        >
          <RangeButtons entry={entry} />
        </div>
      )}
    </figure>
  );
}

/** Returns the rectangles for CanvasSize.corner, enlarged by ROOM. */
const cornersOf = ({ handles }: Overlay, stage: Size): Size[] =>
  handles
    .filter(({ id }) => /^legend \d+$/.test(id))
    .map(({ box }) => ({ width: stage.width - box.left + ROOM.width, height: box.bottom + ROOM.height }));

/** The texts of the picture for screen readers, which cannot read the drawing. */
function ForReaders({ title, captions }: { title: string; captions: readonly string[] }): JSX.Element {
  return (
    <div class="for-readers">
      {title !== "" && <h2>{title}</h2>}
      {captions.map((caption) => (
        <p key={caption}>{caption}</p>
      ))}
    </div>
  );
}

export function Texts(): JSX.Element {
  const commands = useCommands();
  const name = useModel((model) => model.scene.value?.dataset);
  const background = useModel((model) => model.scene.value?.background);
  const annotations = useModel((model) => model.scene.value?.annotations);
  const shownTime = useShownTime();
  const description = useModel((model) => model.description.value);
  const missing = useModel((model) => model.missing.value);
  const size = useModel((model) => model.canvasSize.value);
  const { entries, complete } = useEntries();
  const { title, dataset, time, scale: zoom } = { ...DEFAULTS.Annotations, ...annotations };
  const hasSteps = (description?.times.length ?? 0) > 1;
  const text = Math.max(SMALLEST_TEXT, textPixels(size) * zoom);
  const isNarrow = size.width <= NARROW;
  const legends = entries.map((entry): LegendText => {
    const { coloring, of, name, scale, lines } = entry;
    return {
      array: coloring.array,
      units: unitsOf(description, coloring.array),
      scale: inBytes(scale),
      layers: name,
      missing: of.layers.some((layer) => missing.includes(layer)),
      bothEnds: coloring.range !== undefined,
      lines,
      controls: isNarrow ? { width: 0, height: 0 } : controlsOf(entry, hasSteps, zoom),
    };
  });
  const captions = [
    ...(dataset && name !== undefined ? [name] : []),
    ...(time ? [`Time: ${numberAlone(shownTime)}`] : []),
  ];
  const wanted = { size, text, background: backgroundColors(background), title, captions, legends };
  const key = JSON.stringify(wanted);
  const { overlay, taken } = useMemo(() => layTexts(wanted), [key]);
  useEffect(() => {
    commands.page.covered(taken);
    if (complete) commands.page.legendsStand(cornersOf(overlay, size));
    return () => commands.page.covered([]);
  }, [commands, key, complete]);
  return (
    <>
      <ForReaders title={title} captions={captions} />
      <svg class="texts" aria-hidden="true">
        <Drawing overlay={overlay} name="texts" />
      </svg>
      <div class="legends">
        {entries.map((entry, i) => (
          <Legend
            key={JSON.stringify([entry.coloring.array, entry.of])}
            entry={entry}
            boxOf={(part) => overlay.handles.find(({ id }) => id === `legend ${i}${part}`)?.box}
            text={text}
            zoom={zoom}
            floats={isNarrow && controlsOf(entry, hasSteps, zoom).height > 0}
          />
        ))}
      </div>
    </>
  );
}
