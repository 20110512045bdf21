// Volumes: the mesh as a coloured fog, by one array.
import type { JSX } from "preact";
import type { Range, VolumeLayer } from "../generated/protocol";
import { rangeOf } from "../scene/color_range";
import { coloredBy } from "../scene/new_looks";
import { DEFAULT_OPACITY, firstOpacity, inserted, middleOfGap, type OpacityPoint } from "../scene/opacity";
import { arrayOf, firstScalar, layersOf, scalarsOf, shownTime, unitsOf } from "../scene/scalars";
import { ColoringFields, OpacityField } from "./coloring";
import { Check, IconButton, NumberField, Section, SelectField } from "./controls";
import { useApp, useAppState } from "./context";
import { OpacityEditor } from "./opacity_editor";
import { RemoveButton } from "./remove_button";

const MOST_SLICES = 1000;
const DIRECTIONS = [
  { value: "auto", text: "Axis nearest the view" },
  { value: "x", text: "X" },
  { value: "y", text: "Y" },
  { value: "z", text: "Z" },
  { value: "screen", text: "Facing the screen" },
];

function VolumeFields({ id, layer }: { id: string; layer: VolumeLayer }): JSX.Element {
  const { actions } = useApp();
  const units = useAppState((state) => state.description?.length_units) ?? "";
  const setSlices = (typed: number): void => {
    const slices = Math.round(typed);
    actions.setLayer(id, { slices: slices > 0 ? slices : null }); // 0 is auto, as of the unit length
  };
  return (
    <div class="fields">
      <SelectField
        label="Slices across"
        value={layer.direction ?? "auto"}
        options={DIRECTIONS}
        onChange={(direction) => actions.setLayer(id, { direction })}
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
          onChange={(typed) => actions.setLayer(id, { unit_length: typed > 0 ? typed : null })}
        />
      </label>
      <Check label="Shaded" checked={layer.shaded !== false} onChange={(shaded) => actions.setLayer(id, { shaded })} />
    </div>
  );
}

function VolumeCard({ id, layer }: { id: string; layer: VolumeLayer }): JSX.Element {
  const { actions, editor, histograms } = useApp();
  const description = useAppState((state) => state.description);
  const scene = useAppState((state) => state.scene);
  useAppState((state) => state.histogramsAt);
  const visible = layer.visible !== false;
  const time = shownTime(description, scene);
  const histogram = description === null ? null : histograms.get(description.name, layer.array, time);
  const data: Range = histogram?.range ?? arrayOf(description, layer.array)?.range ?? [0, 1];
  const points: readonly OpacityPoint[] = layer.opacity_points ?? DEFAULT_OPACITY;
  const setPoints = (opacity_points: OpacityPoint[], gesture?: string): void =>
    actions.setLayer(id, { opacity_points }, gesture);
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Volume of ${layer.array}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Hide this volume" : "Show this volume"}
          pressed={visible}
          onClick={() => actions.setLayer(id, { visible: !visible })}
        />
        <SelectField
          label="Array of the volume"
          hideLabel
          value={layer.array}
          options={scalarsOf(description).map(({ name }) => ({ value: name, text: name }))}
          onChange={(array) => actions.setLayer(id, { array, color: { array: null, range: null } })}
        />
        <IconButton
          icon="plus"
          label="Add an opacity point"
          onClick={() => setPoints(inserted(points, middleOfGap(points))[0])}
        />
        <RemoveButton label="Remove this volume" onClick={() => actions.removeLayer(id)} />
      </div>
      <OpacityEditor
        name={layer.array}
        units={unitsOf(description, layer.array)}
        range={rangeOf(layer.color ?? {}, data)}
        logarithmic={layer.color?.log === true}
        histogram={histogram}
        points={points}
        newGesture={() => editor.newGesture()}
        onChange={setPoints}
      />
      <ColoringFields of={{ layers: [id] }} coloring={{ ...layer.color, array: layer.array }} ofArray />
      <VolumeFields id={id} layer={layer} />
      <OpacityField id={id} opacity={layer.opacity ?? 1} />
    </article>
  );
}

export function VolumeSection(): JSX.Element {
  const { actions, histograms } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  const first = firstScalar(description);
  const volumes = layersOf(scene, "volume");
  const add = (): void => {
    if (first === undefined || description === null) return;
    const counts = histograms.get(description.name, first, shownTime(description, scene))?.counts ?? null;
    const color = coloredBy(scene, description, first);
    delete color.array; // a volume names it itself
    actions.addLayer("volume", { type: "volume", array: first, color, opacity_points: firstOpacity(counts) });
  };
  return (
    <Section
      title="Volumes"
      action={first === undefined ? null : <IconButton icon="plus" label="Add a volume" onClick={add} />}
    >
      {volumes.map(([id, layer]) => (
        <VolumeCard key={id} id={id} layer={layer} />
      ))}
      {volumes.length === 0 && <p class="hint">None. A volume shows an array everywhere at once, as a coloured fog.</p>}
    </Section>
  );
}
