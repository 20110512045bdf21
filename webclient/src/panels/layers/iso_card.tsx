// Settings of an iso-surface layer: array, values over a histogram, colors.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { DEFAULTS, type IsoLayer, type Range } from "../../generated/protocol";
import { formatNumber, logarithmicStart } from "../../model/numbers";
import { arrayOf, scalarsOf, unitsOf } from "../../model/scalars";
import { ColoringFields, OpacityField } from "../color/coloring";
import { Check, IconButton, SelectField } from "../controls/controls";
import { useCommands, useModel, useShownTime } from "../context";
import { HistogramSlider } from "../controls/histogram_slider";
import { EdgesFields } from "./line_fields";
import { RemoveButton } from "../controls/remove_button";
import { replaced, ValueRow } from "../controls/value_row";

interface Scales {
  counts: boolean;
  axis: boolean;
}

/** Logarithmic counts keep rare values visible. A logarithmic axis spreads values of several decades. */
function ScaleButtons({
  scales,
  set,
  range,
}: {
  scales: Scales;
  set: (to: Scales) => void;
  range: Range;
}): JSX.Element {
  const hasAxis = logarithmicStart(range) !== null;
  return (
    <span class="scales">
      <button
        type="button"
        class="button small log"
        aria-pressed={hasAxis && scales.axis}
        disabled={!hasAxis}
        title={hasAxis ? "Logarithmic slider" : "A logarithmic slider needs an array without negative values"}
        onClick={() => set({ ...scales, axis: !scales.axis })}
      >
        log axis
      </button>
      <button
        type="button"
        class="button small log"
        aria-pressed={scales.counts}
        title="Logarithmic counts in the histogram"
        onClick={() => set({ ...scales, counts: !scales.counts })}
      >
        log counts
      </button>
    </span>
  );
}

function OutsideHint({ values, range }: { values: readonly number[]; range: Range }): JSX.Element | null {
  const outside = values.filter((value) => value < range[0] || value > range[1]);
  if (outside.length === 0) return null;
  const span = range[1] - range[0];
  return (
    <p class="hint" role="status">
      {outside.length === values.length ? "No surface" : "Not all surfaces"}: the data goes from{" "}
      {formatNumber(range[0], span)} to {formatNumber(range[1], span)}.
    </p>
  );
}

export function IsoCard({ id, layer }: { id: string; layer: IsoLayer }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const time = useShownTime();
  const [scales, setScales] = useState<Scales>({ counts: true, axis: false });
  const visible = layer.visible !== false;
  const units = unitsOf(description, layer.array);
  const histogram = description === null ? null : commands.histogram(description.name, layer.array, time);
  const own = arrayOf(description, layer.array)?.range;
  const range: Range = histogram?.range ?? own ?? [Math.min(0, ...layer.values), Math.max(1, ...layer.values)];
  const setValues = (values: number[], gesture?: string): void => commands.layers.set(id, { values }, gesture);
  const changeArray = (array: string): void =>
    commands.layers.set(id, { array, values: [commands.layers.middleOf(array)] });
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Iso-surface of ${layer.array}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Hide this iso-surface" : "Show this iso-surface"}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <SelectField
          label="Array of the iso-surface"
          hideLabel
          value={layer.array}
          options={scalarsOf(description).map(({ name }) => ({ value: name, text: name }))}
          onChange={changeArray}
        />
        <RemoveButton label="Remove this iso-surface" onClick={() => commands.layers.remove(id)} />
      </div>
      <HistogramSlider
        name={layer.array}
        units={units}
        range={range}
        histogram={histogram}
        logarithmicCounts={scales.counts}
        logarithmicAxis={scales.axis}
        values={layer.values}
        newGesture={() => commands.newGesture()}
        onChange={(index, value, gesture) => setValues(replaced(layer.values, index, value), gesture)}
      />
      <ValueRow values={layer.values} range={range} setValues={setValues} alone="Iso-value" numbered="Value">
        <ScaleButtons scales={scales} set={setScales} range={range} />
      </ValueRow>
      <OutsideHint values={layer.values} range={range} />
      <ColoringFields of={{ layers: [id] }} coloring={layer.color ?? {}} />
      <OpacityField id={id} opacity={layer.opacity ?? DEFAULTS.IsoLayer.opacity} />
      <Check
        label="Smooth"
        checked={layer.smooth !== false}
        onChange={(smooth) => commands.layers.set(id, { smooth })}
      />
      <EdgesFields id={id} edges={layer.edges} />
    </article>
  );
}
