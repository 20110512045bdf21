// Settings of a slice's contour lines: array, values, color and width.
import type { JSX } from "preact";
import { DEFAULTS, type Coloring, type Contours, type Range, type SliceLayer } from "../../generated/protocol";
import { COUNTS, evenValues, mapBeside, ofArray, type ContoursChange } from "../../model/contours";
import { withEnd } from "../../model/numbers";
import { firstScalar, scalarsOf } from "../../model/scalars";
import { ColoringFields } from "../color/coloring";
import { Check, NumberField, SelectField } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { useSomeRange } from "../color/data_range";
import { LineStyleFields } from "./line_fields";
import { RangeRow } from "../controls/range_row";
import { ValueRow } from "../controls/value_row";

interface FieldsProps {
  contours: Contours;
  set: (change: ContoursChange) => void;
}

function RangeField({ contours, data, set }: FieldsProps & { data: Range }): JSX.Element {
  const range = contours.range ?? data;
  return (
    <RangeRow
      label="Range of the contour lines"
      text="Between"
      from="Contour lines from"
      to="Contour lines to"
      range={range}
      span={range[1] - range[0]}
      setEnd={(end, to) => set({ range: withEnd(range, end, to) })}
      ofData={!contours.range}
      dataTitle="Between the lowest and the highest value of the data at each time"
      setData={() => set({ range: null })}
    />
  );
}

function ValuesFields({ contours, set }: FieldsProps): JSX.Element {
  const data = useSomeRange(contours.array);
  const { values } = contours;
  return (
    <>
      <div class="fields">
        <SelectField
          label="Lines at"
          value={values === undefined ? "even" : "own"}
          options={[
            { value: "even", text: "even values" },
            { value: "own", text: "own values" },
          ]}
          onChange={(at) =>
            set(at === "own" ? { values: evenValues(contours, data), count: null, range: null } : { values: null })
          }
        />
        {values === undefined && (
          <label class="field">
            <span>Number</span>
            <NumberField
              label="Number of contour lines"
              value={contours.count ?? DEFAULTS.Contours.count}
              step={1}
              limits={COUNTS}
              onChange={(typed) => set({ count: Math.round(typed) })}
            />
          </label>
        )}
      </div>
      {values === undefined ? (
        <RangeField contours={contours} data={data} set={set} />
      ) : (
        <ValueRow
          values={values}
          range={data}
          setValues={(to) => set({ values: to })}
          alone="Value of the contour line"
          numbered="Contour value"
        />
      )}
    </>
  );
}

function LooksFields({
  id,
  contours,
  below,
  set,
}: FieldsProps & { id: string; below: Coloring | undefined }): JSX.Element {
  const { coloring } = contours;
  return (
    <>
      <LineStyleFields
        label="the contour lines"
        color={coloring === undefined ? (contours.color ?? DEFAULTS.Contours.color) : null}
        width={contours.width ?? DEFAULTS.Contours.width}
        onChange={set}
      />
      <Check
        label="Lines in the colors of their values"
        checked={coloring !== undefined}
        onChange={(on) => set({ coloring: on ? { map: mapBeside(below) } : null })}
      />
      {coloring !== undefined && (
        <ColoringFields
          of={{ layers: [], contours: [id] }}
          coloring={{ ...coloring, array: contours.array }}
          ofArray
          mapLabel="Map of the lines"
        />
      )}
    </>
  );
}

export function ContourFields({ id, slice }: { id: string; slice: SliceLayer }): JSX.Element | null {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const { color, contours } = slice;
  const array = color?.array ?? firstScalar(description);
  if (array === undefined) return null;
  const set = (change: ContoursChange): void =>
    commands.layers.set(id, { contours: contours === undefined ? { array, ...change } : change });
  return (
    <>
      <Check
        label="Contour lines"
        checked={contours !== undefined && contours.visible !== false}
        onChange={(visible) => set({ visible })}
      />
      {contours !== undefined && contours.visible !== false && (
        <>
          <SelectField
            label="Lines of"
            value={contours.array}
            options={scalarsOf(description).map(({ name }) => ({ value: name, text: name }))}
            onChange={(chosen) => set(ofArray(contours, chosen))}
          />
          <ValuesFields contours={contours} set={set} />
          <LooksFields id={id} contours={contours} below={color} set={set} />
        </>
      )}
    </>
  );
}
