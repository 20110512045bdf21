// Contour lines of slices: of which array, at how many values, in one colour or in those of their values.
import type { JSX } from "preact";
import { colorMapNames, DEFAULT_MAP } from "../display/color_maps";
import type { Contours } from "../generated/protocol";
import { clamp } from "../scene/numbers";
import { firstScalar, scalarsOf } from "../scene/scalars";
import { Check, NumberField, SelectField } from "./controls";
import { useApp, useAppState } from "./context";
import { LineStyleFields } from "./line_fields";

const DEFAULT_COUNT = 10;
const MOST = 64;

/** `color`: the array that colours the slices, which is what contours begin with. */
export function ContourFields({
  layers,
  contours,
  color,
}: {
  layers: string[];
  contours: Contours | undefined;
  color: string | undefined;
}): JSX.Element | null {
  const { editor } = useApp();
  const description = useAppState((state) => state.description);
  const scalars = scalarsOf(description);
  const first = color ?? firstScalar(description);
  const shown = contours !== undefined && contours.visible !== false;
  const set = (change: { [K in keyof Contours]?: Contours[K] | null }): void =>
    editor.change({ layers: Object.fromEntries(layers.map((id) => [id, { contours: change }])) });
  const coloring = contours?.coloring;
  if (first === undefined) return null;
  return (
    <>
      <Check
        label="Contour lines"
        checked={shown}
        onChange={(visible) => set(contours === undefined ? { array: first } : { visible })}
      />
      {shown && (
        <>
          <div class="fields">
            <SelectField
              label="Lines of"
              value={contours.array}
              options={scalars.map(({ name }) => ({ value: name, text: name }))}
              onChange={(array) =>
                set({
                  array,
                  values: null, // they and the ranges belonged to the array before
                  range: null,
                  ...(coloring && { coloring: { ...coloring, array, range: null } }),
                })
              }
            />
            <label class="field">
              <span>Number</span>
              <NumberField
                label="Number of contour lines"
                value={contours.values?.length ?? contours.count ?? DEFAULT_COUNT}
                step={1}
                onChange={(typed) => set({ values: null, count: clamp(Math.round(typed), 1, MOST) })}
              />
            </label>
          </div>
          <LineStyleFields
            label="the contour lines"
            color={contours.color ?? "#1a1a1a"}
            width={contours.width ?? 1.5}
            onChange={set}
          />
          <Check
            label="Lines in the colours of their values"
            checked={coloring !== undefined}
            onChange={(on) => set({ coloring: on ? { map: DEFAULT_MAP } : null })}
          />
          {coloring !== undefined && (
            <SelectField
              label="Map of the lines"
              value={coloring.map ?? DEFAULT_MAP}
              options={colorMapNames.map((name) => ({ value: name, text: name }))}
              onChange={(map) => set({ coloring: { map } })}
            />
          )}
        </>
      )}
    </>
  );
}
