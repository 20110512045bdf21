// Settings of boundary layers. Each layer shows the whole boundary or some patches, and has its own coloring and edges.
import type { JSX } from "preact";
import { DEFAULTS, type SurfaceLayer } from "../../generated/protocol";
import { freshSolid } from "../../model/new_looks";
import { layersOf } from "../../model/scalars";
import { ColoringFields, OpacityField } from "../color/coloring";
import { IconButton, Section } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { EdgesFields } from "./line_fields";
import { PatchList } from "./patch_list";
import { RemoveButton } from "../controls/remove_button";
import { ThresholdFields } from "./threshold_fields";

function LookFields({ id, layer }: { id: string; layer: SurfaceLayer }): JSX.Element {
  return (
    <>
      <ColoringFields of={{ layers: [id] }} coloring={layer.color ?? {}} ofPatches />
      <OpacityField id={id} opacity={layer.opacity ?? DEFAULTS.SurfaceLayer.opacity} />
      <ThresholdFields id={id} threshold={layer.threshold} color={layer.color?.array} />
      <EdgesFields id={id} edges={layer.edges} />
    </>
  );
}

function FurtherCard({ id, layer, number }: { id: string; layer: SurfaceLayer; number: number }): JSX.Element {
  const commands = useCommands();
  const visible = layer.visible !== false;
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Boundary ${number}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={`${visible ? "Hide" : "Show"} boundary ${number}`}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <span class="card-title">Boundary {number}</span>
        <RemoveButton label={`Remove boundary ${number}`} onClick={() => commands.layers.remove(id)} />
      </div>
      {visible && <LookFields id={id} layer={layer} />}
      <PatchList
        groups={layer.groups ?? []}
        shown={visible}
        onChange={(groups) => commands.layers.set(id, groups === null ? { visible: false } : { visible: true, groups })}
      />
    </article>
  );
}

export function BoundarySection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const description = useModel((model) => model.description.value);
  const [entry, ...further] = layersOf(layers, "surface");
  const shown = entry !== undefined && entry[1].visible !== false;
  const show = (groups: string[] | null): void => {
    if (entry !== undefined)
      commands.layers.set(entry[0], groups === null ? { visible: false } : { visible: true, groups });
    else if (groups !== null) commands.layers.add("surface", { type: "surface", groups });
  };
  // A new layer starts with a patch that no other layer shows, because coincident layers would hide each other.
  const addFurther = (): void => {
    const taken = new Set(layersOf(layers, "surface").flatMap(([, layer]) => layer.groups ?? []));
    const free = description?.groups.find(({ of, name }) => of === "faces" && !taken.has(name));
    const groups = free === undefined ? [] : [free.name];
    commands.layers.add("surface", { type: "surface", groups, color: freshSolid(layers, "surface") });
  };
  const button = entry && (
    <IconButton
      icon="plus"
      label="Add another layer of the boundary"
      text="Add"
      disabled={description === null}
      onClick={addFurther}
    />
  );
  return (
    <Section title="Boundary" action={button ?? null}>
      {entry !== undefined && shown && <LookFields id={entry[0]} layer={entry[1]} />}
      <PatchList groups={entry?.[1].groups ?? []} shown={shown} onChange={show} />
      {further.map(([id, layer], index) => (
        <FurtherCard key={id} id={id} layer={layer} number={index + 2} />
      ))}
    </Section>
  );
}
