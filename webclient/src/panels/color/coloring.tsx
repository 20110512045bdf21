// Fields that choose how a layer is colored: by an array through a color map, or with one color.
import type { JSX } from "preact";
import { DEFAULTS, type Coloring } from "../../generated/protocol";
import { DEFAULT_MAP, colorMapNames } from "../../model/color_maps";
import { withMap } from "../../model/color_edit";
import { allScalarsOf, boundaryScalarsOf, scalarsOf, type Colored, type ScaledColoring } from "../../model/scalars";
import { SelectField, Slider } from "../controls/controls";
import { ColorScalePanel } from "./color_scale_panel";
import { useCommands, useModel } from "../context";
import { useSomeRange } from "./data_range";

const SOLID = "";
const OWN = "";
export const DEFAULT_SOLID = DEFAULTS.Coloring.solid;

function Scale(props: { of: Colored; coloring: ScaledColoring }): JSX.Element {
  return <ColorScalePanel {...props} data={useSomeRange(props.coloring.array)} />;
}

interface ColoringProps {
  of: Colored;
  coloring: Coloring;
  /** Hides the field for the array. Set for volumes and contour lines, which have another field for the array. */
  ofArray?: boolean;
  /** Offers only arrays at points. Lines and points lie between several cells, so that they have no cell value. */
  ofPoints?: boolean;
  /** Also offers arrays at boundary faces. Only the boundary has values of these arrays. */
  ofPatches?: boolean;
  mapLabel?: string;
}

export function ColoringFields({
  of,
  coloring,
  ofArray = false,
  ofPoints = false,
  ofPatches = false,
  mapLabel = "Map",
}: ColoringProps): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const ofCells = ofPatches ? boundaryScalarsOf : allScalarsOf;
  const scalars = (ofPoints ? scalarsOf : ofCells)(description);
  const arrays = [
    { value: SOLID, text: "One color" },
    ...scalars.map(({ name, units }) => ({ value: name, text: units === "" ? name : `${name} (${units})` })),
  ];
  const own = coloring.points ? [{ value: OWN, text: "Own colors" }] : [];
  const maps = [...own, ...colorMapNames().map((name) => ({ value: name, text: name }))];
  return (
    <div class="fields">
      {!ofArray && (
        <SelectField
          label="Color by"
          value={coloring.array ?? SOLID}
          options={arrays}
          onChange={(array) => commands.colors.by(of, array === SOLID ? null : array)}
        />
      )}
      {coloring.array === undefined ? (
        <label class="field">
          <span>Color</span>
          <input
            type="color"
            aria-label="Color"
            value={coloring.solid ?? DEFAULT_SOLID}
            onChange={(event) => commands.colors.set(of, { solid: event.currentTarget.value })}
          />
        </label>
      ) : (
        <SelectField
          label={mapLabel}
          value={coloring.points ? OWN : (coloring.map ?? DEFAULT_MAP)}
          options={maps}
          onChange={(map) => {
            if (map !== OWN) commands.colors.set(of, withMap(map));
          }}
        />
      )}
      {coloring.array !== undefined && <Scale of={of} coloring={{ ...coloring, array: coloring.array }} />}
    </div>
  );
}

/** Renders nothing if the layer is outside the data, because other fields report this. */
export function EmptyHint({ id }: { id: string }): JSX.Element | null {
  const empty = useModel((model) => model.empty.value);
  const found = empty.find(({ layer, why }) => layer === id && why !== "outside");
  if (found === undefined) return null;
  return (
    <p class="hint" role="status">
      The layer shows nothing. {found.reason}
    </p>
  );
}

function OpacitySlider({ id, opacity }: { id: string; opacity: number }): JSX.Element {
  const commands = useCommands();
  const percent = Math.round(opacity * 100);
  return (
    <div class="field opacity">
      <span>Opacity</span>
      <Slider
        label="Opacity"
        min={5}
        max={100}
        step={5}
        value={percent}
        text={`${percent} %`}
        newGesture={() => commands.newGesture()}
        onChange={(value, gesture) => commands.layers.set(id, { opacity: value / 100 }, gesture)}
      />
      <output>{percent} %</output>
    </div>
  );
}

export function OpacityField({ id, opacity }: { id: string; opacity: number }): JSX.Element {
  return (
    <>
      <OpacitySlider id={id} opacity={opacity} />
      <EmptyHint id={id} />
    </>
  );
}
