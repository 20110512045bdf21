import type { JSX } from "preact";
import { freshSolid } from "../../model/new_looks";
import { layersOf, scalarsOf } from "../../model/scalars";
import { IconButton, Section } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { IsoCard } from "./iso_card";

export function IsoSection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const description = useModel((model) => model.description.value);
  const isos = layersOf(layers, "iso");
  const scalars = scalarsOf(description);
  const add = (): void => {
    const scalar = scalars.find(({ name }) => !isos.some(([, layer]) => layer.array === name)) ?? scalars[0];
    if (scalar === undefined) return;
    commands.layers.add("iso", {
      type: "iso",
      array: scalar.name,
      values: [commands.layers.middleOf(scalar.name)],
      color: freshSolid(layers, "iso"),
    });
  };
  const button = (
    <IconButton icon="plus" label="Add an iso-surface" text="Add" disabled={scalars.length === 0} onClick={add} />
  );
  return (
    <Section title="Iso-surfaces" action={button}>
      {isos.map(([id, layer]) => (
        <IsoCard key={id} id={id} layer={layer} />
      ))}
      {isos.length === 0 && (
        <p class="hint">
          {description !== null && scalars.length === 0
            ? "This dataset has no point array to make a surface from."
            : "None. Add one to see where an array takes a value."}
        </p>
      )}
    </Section>
  );
}
