// Settings of the planes that clip all layers: position, kept side, caps.
import type { JSX } from "preact";
import { boundsCenter } from "../../model/camera";
import type { ClipLayer } from "../../generated/protocol";
import { AXES, type Across } from "../../model/axes";
import { capColoring, keepsFarHalf, normalOf } from "../../model/new_looks";
import { layersOf } from "../../model/scalars";
import { AddPlaneRow } from "./add_plane_row";
import { ColoringFields } from "../color/coloring";
import { Check, IconButton, Section } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { PlaneFields } from "./plane_fields";
import { PositionRow } from "./position_row";
import { RemoveButton } from "../controls/remove_button";

const MOST_SHOWN = 6;

function ClipCard({ id, layer }: { id: string; layer: ClipLayer }): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const visible = layer.visible !== false;
  const name = layer.axis === undefined ? "Free plane" : `Across ${layer.axis}`;
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Clip: ${name}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Switch this clip off" : "Switch this clip on"}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <span class="card-title">{name}</span>
        <RemoveButton label="Remove this clip" onClick={() => commands.layers.remove(id)} />
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
        onChange={(invert) => commands.layers.set(id, { invert })}
      />
      <Check label="Caps" checked={layer.caps !== false} onChange={(caps) => commands.layers.set(id, { caps })} />
      {layer.caps !== false && (
        <Check
          label="Caps in colors of their own"
          checked={layer.color !== undefined}
          onChange={(own) =>
            commands.layers.set(id, { color: own ? (capColoring(null, description).color ?? {}) : null })
          }
        />
      )}
      {layer.caps !== false && layer.color !== undefined && (
        <ColoringFields of={{ layers: [id] }} coloring={layer.color} />
      )}
    </article>
  );
}

export function ClipSection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const description = useModel((model) => model.description.value);
  const clips = layersOf(layers, "clip");
  const full = clips.filter(([, layer]) => layer.visible !== false).length >= MOST_SHOWN;
  const add = (across: Across): void => {
    if (description === null) return;
    const center = boundsCenter(description.bounds);
    const normal = normalOf(across);
    const looks = {
      ...capColoring(layers, description),
      ...(keepsFarHalf(normal, commands.camera.get()) && { invert: true }),
    };
    if (across === "free") commands.layers.add("clip", { type: "clip", origin: center, normal, ...looks });
    else {
      const value = center[AXES.indexOf(across)] ?? 0;
      commands.layers.add(`clip-${across}`, { type: "clip", axis: across, value, ...looks });
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
