// Settings of a color scale except its array.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import { colorRow, hexOf, isShownBy, rangeOf, scaleOf, type ColorScale } from "../../model/color_scale";
import { LIMITS, type Coloring, type Range } from "../../generated/protocol";
import {
  pointsOf,
  withMap,
  withDataRange,
  withRangeEnd,
  withSymmetric,
  withSymmetricLog,
  type ColoringChange,
} from "../../model/color_edit";
import { formatNumber } from "../../model/numbers";
import { rangeOfAllSteps, type Colored, type ScaledColoring } from "../../model/scalars";
import { PointsEditor } from "./color_points";
import { gradientOf, MapGallery } from "./color_swatch";
import { Check, NumberField } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { Icon } from "../controls/icons";
import { RangeRow } from "../controls/range_row";

interface Props {
  of: Colored;
  coloring: ScaledColoring;
  /** Range of the array at the shown time step. */
  data: Range;
}

type Change = (change: ColoringChange, gesture?: string) => void;

function ColorField(props: { label: string; value: string; onChange: (color: string) => void }): JSX.Element {
  const { label, value, onChange } = props;
  return (
    <input type="color" aria-label={label} value={value} onChange={(event) => onChange(event.currentTarget.value)} />
  );
}

function RangeFields({ of, coloring, data, change }: Props & { change: Change }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const range = rangeOf(coloring, data);
  const span = coloring.log === true ? undefined : range[1] - range[0];
  const set = (changed: ColoringChange | string): void => {
    if (typeof changed === "string") commands.tell(changed, "error");
    else change(changed);
  };
  const setData = (to: Range | null): void => {
    if (to !== null) set(withDataRange(coloring, to));
  };
  const everywhere = rangeOfAllSteps(description, coloring.array);
  return (
    <RangeRow
      label="Range of the colors"
      text="Range"
      from="Range from"
      to="Range to"
      range={range}
      span={span}
      setEnd={(end, to) => set(withRangeEnd(coloring, range, end, to))}
      ofData={!coloring.range}
      dataTitle="The range of the data at each time"
      setData={() => change({ range: undefined })}
    >
      <button
        type="button"
        class="button small"
        title="The range of the values that are in view now"
        onClick={() => void commands.colors.rangeInView(of).then(setData)}
      >
        In view
      </button>
      <button
        type="button"
        class="button small"
        title="The range of the values at this time without the lowest and the highest hundredth of them"
        onClick={() => void commands.colors.usualRange(coloring.array).then(setData)}
      >
        1–99 %
      </button>
      {everywhere !== null && (description?.times.length ?? 0) > 1 && (
        <button type="button" class="button small" title="The range at all times" onClick={() => setData(everywhere)}>
          All times
        </button>
      )}
    </RangeRow>
  );
}

function OutsideFields({
  coloring,
  scale,
  change,
}: {
  coloring: Coloring;
  scale: ColorScale;
  change: Change;
}): JSX.Element {
  const [low = [0, 0, 0], high = low] = colorRow({ ...scale, steps: 0 }, 2);
  const ends = { below: hexOf(low), above: hexOf(high) };
  const end = (member: "below" | "above", label: string): JSX.Element => (
    <div class="outside-row">
      <Check
        label={label}
        checked={Boolean(coloring[member])}
        onChange={(on) => change({ [member]: on ? ends[member] : undefined })}
      />
      {coloring[member] && (
        <ColorField
          label={`Color of values ${member} the range`}
          value={coloring[member]}
          onChange={(color) => change({ [member]: color })}
        />
      )}
    </div>
  );
  return (
    <div role="group" aria-label="Colors outside the range">
      {end("below", "Below the range")}
      {end("above", "Above the range")}
      <div class="outside-row">
        <span>Missing values</span>
        <ColorField label="Color of missing values" value={scale.nan} onChange={(nan) => change({ nan })} />
      </div>
    </div>
  );
}

interface WaysProps {
  of: Colored;
  coloring: Coloring;
  scale: ColorScale;
  change: Change;
}

function Ways({ of, coloring, scale, change }: WaysProps): JSX.Element {
  const commands = useCommands();
  const isBoth = scale.log && coloring.symmetric === true;
  const steps = coloring.steps ?? null;
  return (
    <>
      <div class="scale-checks">
        <Check label="Reverse" checked={scale.reverse} onChange={(on) => change({ reverse: on || undefined })} />
        <Check
          label="Logarithmic"
          checked={scale.log && !isBoth}
          onChange={(on) => commands.colors.setLog(of, coloring, on)}
        />
        <Check
          label="Symmetric"
          checked={coloring.symmetric === true && !isBoth}
          onChange={(on) => change(withSymmetric(on))}
        />
        <Check label="Symmetric log" checked={isBoth} onChange={(on) => change(withSymmetricLog(on))} />
        <div class="outside-row">
          <Check label="Steps" checked={steps !== null} onChange={(on) => change({ steps: on ? 10 : undefined })} />
          {steps !== null && (
            <NumberField
              label="Number of steps"
              value={steps}
              step={1}
              limits={LIMITS.Coloring.steps}
              onChange={(count) => change({ steps: Math.round(count) })}
            />
          )}
        </div>
      </div>
    </>
  );
}

export function ColorScalePanel({ of, coloring, data }: Props): JSX.Element {
  const commands = useCommands();
  const [isOpen, setOpen] = useState(false);
  const scale = scaleOf(coloring, data);
  const change: Change = (part, gesture) => commands.colors.set(of, part, gesture);
  const own = scale.points.length > 0;
  return (
    <div class="scale-panel">
      <button
        type="button"
        class="scale-title"
        aria-expanded={isOpen}
        aria-label={`Color scale of ${of.contours ? "the lines of " : ""}${coloring.array}`}
        onClick={() => setOpen(!isOpen)}
      >
        <Icon name="chevron" />
        <span class="scale-preview" style={{ background: gradientOf(scale) }} />
      </button>
      {isOpen && (
        <div class="scale-body">
          {!own && <MapGallery scale={scale} onChoose={(map) => change(withMap(map))} />}
          <Check
            label="Colors of my own"
            checked={own}
            onChange={(on) => change({ points: on ? pointsOf(scale) : undefined })}
          />
          {own && <PointsEditor scale={scale} onChange={(points, gesture) => change({ points }, gesture)} />}
          <Ways of={of} coloring={coloring} scale={scale} change={change} />
          {!isShownBy(coloring, data) && (
            <p class="hint" role="status">
              {coloring.array} has no value above zero now: a logarithmic scale shows none.
            </p>
          )}
          {scale.log && coloring.symmetric !== true && data[0] < 0 && data[1] > 0 && (
            <p class="hint" role="status">
              {`${coloring.array} goes down to ${formatNumber(data[0])}: values up to zero have the color of `}
              {coloring.below ? "values below the range." : "the lower end."}
            </p>
          )}
          <RangeFields of={of} coloring={coloring} data={data} change={change} />
          <OutsideFields coloring={coloring} scale={scale} change={change} />
        </div>
      )}
    </div>
  );
}
