// Settings of volume layers, which show the mesh as a volume colored by an array.
import type { JSX } from "preact";
import { DEFAULTS, LIMITS, type Range, type VolumeLayer } from "../../generated/protocol";
import { rangeOf } from "../../model/color_scale";
import { coloredBy } from "../../model/new_looks";
import {
  DEFAULT_OPACITY,
  firstOpacity,
  inserted,
  middleOfGap,
  MOST_POINTS,
  type OpacityPoint,
} from "../../model/opacity";
import { arrayOf, firstScalar, layersOf, scalarsOf, unitsOf } from "../../model/scalars";
import { ColoringFields, OpacityField } from "../color/coloring";
import { Check, IconButton, NumberField, Section, SelectField } from "../controls/controls";
import { useCommands, useLayers, useModel, useShownTime } from "../context";
import { OpacityEditor } from "./opacity_editor";
import { RemoveButton } from "../controls/remove_button";

const [, MOST_SLICES] = LIMITS.VolumeLayer.slices;
const DIRECTIONS = [
  { value: "auto", text: "Axis nearest the view" },
  { value: "x", text: "X" },
  { value: "y", text: "Y" },
  { value: "z", text: "Z" },
  { value: "screen", text: "Facing the screen" },
];

function VolumeFields({ id, layer }: { id: string; layer: VolumeLayer }): JSX.Element {
  const commands = useCommands();
  const units = useModel((model) => model.description.value?.length_units) ?? "";
  const setSlices = (typed: number): void => {
    const slices = Math.round(typed);
    commands.layers.set(id, { slices: slices > 0 ? slices : null }); // 0: the server chooses the number
  };
  return (
    <div class="fields">
      <SelectField
        label="Slices across"
        value={layer.direction ?? DEFAULTS.VolumeLayer.direction}
        options={DIRECTIONS}
        onChange={(direction) => commands.layers.set(id, { direction })}
      />
      <label class="field">
        <span>Slices</span>
        <NumberField
          label="Number of slices"
          value={layer.slices ?? null}
          placeholder="auto"
          span={MOST_SLICES}
          step={10}
          limits={[0, MOST_SLICES]}
          onChange={setSlices}
        />
      </label>
      <label class="field">
        <span>Unit length</span>
        <NumberField
          label={`Length${units === "" ? "" : ` in ${units}`} after which the opacity of the curve is reached`}
          value={layer.unit_length ?? null}
          placeholder="auto"
          onChange={(typed) => commands.layers.set(id, { unit_length: typed > 0 ? typed : null })}
        />
      </label>
      <Check
        label="Shaded"
        checked={layer.shaded !== false}
        onChange={(shaded) => commands.layers.set(id, { shaded })}
      />
    </div>
  );
}

function VolumeCard({ id, layer }: { id: string; layer: VolumeLayer }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const time = useShownTime();
  const visible = layer.visible !== false;
  const histogram = description === null ? null : commands.histogram(description.name, layer.array, time);
  const data: Range = histogram?.range ?? arrayOf(description, layer.array)?.range ?? [0, 1];
  const points: readonly OpacityPoint[] = layer.opacity_points ?? DEFAULT_OPACITY;
  const setPoints = (opacity_points: OpacityPoint[], gesture?: string): void =>
    commands.layers.set(id, { opacity_points }, gesture);
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Volume of ${layer.array}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Hide this volume" : "Show this volume"}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <SelectField
          label="Array of the volume"
          hideLabel
          value={layer.array}
          options={scalarsOf(description).map(({ name }) => ({ value: name, text: name }))}
          onChange={(array) => commands.layers.set(id, { array, color: { array: null, range: null } })}
        />
        {points.length < MOST_POINTS && (
          <IconButton
            icon="plus"
            label="Add an opacity point"
            onClick={() => setPoints(inserted(points, middleOfGap(points))[0])}
          />
        )}
        <RemoveButton label="Remove this volume" onClick={() => commands.layers.remove(id)} />
      </div>
      <OpacityEditor
        name={layer.array}
        units={unitsOf(description, layer.array)}
        range={rangeOf(layer.color ?? {}, data)}
        logarithmic={layer.color?.log === true}
        histogram={histogram}
        points={points}
        newGesture={() => commands.newGesture()}
        onChange={setPoints}
      />
      <ColoringFields of={{ layers: [id] }} coloring={{ ...layer.color, array: layer.array }} ofArray />
      <VolumeFields id={id} layer={layer} />
      <OpacityField id={id} opacity={layer.opacity ?? DEFAULTS.VolumeLayer.opacity} />
    </article>
  );
}

export function VolumeSection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const time = useShownTime();
  const description = useModel((model) => model.description.value);
  const first = firstScalar(description);
  const volumes = layersOf(layers, "volume");
  const add = (): void => {
    if (first === undefined || description === null) return;
    const counts = commands.histogram(description.name, first, time)?.counts ?? null;
    const color = coloredBy(layers, description, first);
    delete color.array; // the layer has its own member for the array
    commands.layers.add("volume", { type: "volume", array: first, color, opacity_points: firstOpacity(counts) });
  };
  return (
    <Section
      title="Volumes"
      action={first === undefined ? null : <IconButton icon="plus" label="Add a volume" onClick={add} />}
    >
      {volumes.map(([id, layer]) => (
        <VolumeCard key={id} id={id} layer={layer} />
      ))}
      {volumes.length === 0 && <p class="hint">None. A volume shows an array everywhere at once, as a colored fog.</p>}
    </Section>
  );
}
