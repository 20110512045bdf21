// Planes that cut all layers, each with its place, its side and whether it is closed.
import type { JSX } from "preact";
import type { ClipLayer, Vec3 } from "../generated/protocol";
import { clamp, formatNumber, sliderTrack } from "../scene/numbers";
import { layersOf } from "../scene/scalars";
import { Check, IconButton, NumberField, Section, Slider } from "./controls";
import { useApp, useAppState } from "./context";
import { PlaneFields } from "./plane_fields";

const AXES = ["x", "y", "z"] as const;
const MOST_SHOWN = 6;

function PositionRow({ id, layer, at }: { id: string; layer: ClipLayer; at: number }): JSX.Element {
  const { actions, editor } = useApp();
  const description = useAppState((state) => state.description);
  const low = description?.bounds[2 * at] ?? 0;
  const high = description?.bounds[2 * at + 1] ?? 1;
  const value = layer.value ?? (low + high) / 2;
  const set = (position: number, gesture?: string): void => actions.setLayer(id, { value: position }, gesture);
  return (
    <div class="clip-row">
      <Slider
        label={`Position of the ${AXES[at] ?? ""} clip`}
        {...sliderTrack([low, high])}
        value={value}
        text={`${formatNumber(value, high - low)} ${description?.length_units ?? ""}`.trim()}
        newGesture={() => editor.newGesture()}
        onChange={(position, gesture) => set(clamp(position, low, high), gesture)}
      />
      <NumberField label={`Clip position on ${AXES[at] ?? ""}`} value={value} span={high - low} onChange={set} />
    </div>
  );
}

function ClipCard({ id, layer }: { id: string; layer: ClipLayer }): JSX.Element {
  const { actions } = useApp();
  const visible = layer.visible !== false;
  const name = layer.axis === undefined ? "Free plane" : `Across ${layer.axis}`;
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Clip: ${name}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Switch this clip off" : "Switch this clip on"}
          pressed={visible}
          onClick={() => actions.setLayer(id, { visible: !visible })}
        />
        <span class="card-title">{name}</span>
        <IconButton icon="close" label="Remove this clip" onClick={() => actions.removeLayer(id)} />
      </div>
      {layer.axis === undefined ? (
        <PlaneFields id={id} origin={layer.origin ?? [0, 0, 0]} normal={layer.normal ?? [1, 0, 0]} />
      ) : (
        <PositionRow id={id} layer={layer} at={AXES.indexOf(layer.axis)} />
      )}
      <Check
        label="Other side"
        checked={layer.invert === true}
        onChange={(invert) => actions.setLayer(id, { invert })}
      />
      <Check label="Caps" checked={layer.caps !== false} onChange={(caps) => actions.setLayer(id, { caps })} />
    </article>
  );
}

export function ClipSection(): JSX.Element {
  const { actions } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  const clips = layersOf(scene, "clip");
  const full = clips.filter(([, layer]) => layer.visible !== false).length >= MOST_SHOWN;
  const middle = (at: number): number =>
    ((description?.bounds[2 * at] ?? 0) + (description?.bounds[2 * at + 1] ?? 1)) / 2;
  const centre: Vec3 = [middle(0), middle(1), middle(2)];
  return (
    <Section title="Clip">
      <div class="add-row">
        {AXES.map((axis, at) => (
          <IconButton
            key={axis}
            icon="plus"
            label={`Add a clip across ${axis}`}
            text={axis.toUpperCase()}
            disabled={full || description === null}
            onClick={() => actions.addLayer(`clip-${axis}`, { type: "clip", axis, value: centre[at] ?? 0 })}
          />
        ))}
        <IconButton
          icon="plus"
          label="Add a free clip plane"
          text="Free"
          disabled={full || description === null}
          onClick={() => actions.addLayer("clip", { type: "clip", origin: centre, normal: [1, 1, 0] })}
        />
      </div>
      {clips.map(([id, layer]) => (
        <ClipCard key={id} id={id} layer={layer} />
      ))}
      {full && <p class="hint">Six planes can cut at a time.</p>}
    </Section>
  );
}
