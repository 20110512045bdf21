// Planes that cut all layers, each with its place, its side and whether it is closed.
import type { JSX } from "preact";
import { boundsCentre } from "../camera/camera";
import type { ClipLayer } from "../generated/protocol";
import { AXES, type Across } from "../scene/axes";
import { capColoring, keepsFarHalf, normalOf } from "../scene/new_looks";
import { layersOf } from "../scene/scalars";
import { AddPlaneRow } from "./add_plane_row";
import { ColoringFields } from "./coloring";
import { Check, IconButton, Section } from "./controls";
import { useApp, useAppState } from "./context";
import { PlaneFields } from "./plane_fields";
import { PositionRow } from "./position_row";
import { RemoveButton } from "./remove_button";

const MOST_SHOWN = 6;

function ClipCard({ id, layer }: { id: string; layer: ClipLayer }): JSX.Element {
  const { actions } = useApp();
  const description = useAppState((state) => state.description);
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
        <RemoveButton label="Remove this clip" onClick={() => actions.removeLayer(id)} />
      </div>
      {layer.axis === undefined ? (
        <PlaneFields id={id} origin={layer.origin ?? [0, 0, 0]} normal={layer.normal ?? [1, 0, 0]} />
      ) : (
        <PositionRow
          id={id}
          axis={layer.axis}
          value={layer.value}
          labels={[`Position of the ${layer.axis} clip`, `Clip position on ${layer.axis}`]}
        />
      )}
      <Check
        label="Other side"
        checked={layer.invert === true}
        onChange={(invert) => actions.setLayer(id, { invert })}
      />
      <Check label="Caps" checked={layer.caps !== false} onChange={(caps) => actions.setLayer(id, { caps })} />
      {layer.caps !== false && (
        <Check
          label="Caps in colours of their own"
          checked={layer.color !== undefined}
          onChange={(own) => actions.setLayer(id, { color: own ? (capColoring(null, description).color ?? {}) : null })}
        />
      )}
      {layer.caps !== false && layer.color !== undefined && (
        <ColoringFields of={{ layers: [id] }} coloring={layer.color} />
      )}
    </article>
  );
}

export function ClipSection(): JSX.Element {
  const { actions } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  const clips = layersOf(scene, "clip");
  const full = clips.filter(([, layer]) => layer.visible !== false).length >= MOST_SHOWN;
  const add = (across: Across): void => {
    if (description === null) return;
    const centre = boundsCentre(description.bounds);
    const normal = normalOf(across);
    const looks = {
      ...capColoring(scene, description),
      ...(keepsFarHalf(normal, actions.camera()) && { invert: true }),
    };
    if (across === "free") actions.addLayer("clip", { type: "clip", origin: centre, normal, ...looks });
    else {
      const value = centre[AXES.indexOf(across)] ?? 0;
      actions.addLayer(`clip-${across}`, { type: "clip", axis: across, value, ...looks });
    }
  };
  return (
    <Section title="Clip">
      <AddPlaneRow what="clip" disabled={full || description === null} add={add} />
      {clips.map(([id, layer]) => (
        <ClipCard key={id} id={id} layer={layer} />
      ))}
      {full && <p class="hint">Six planes can cut at a time.</p>}
    </Section>
  );
}
