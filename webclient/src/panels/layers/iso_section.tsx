import type { JSX } from "preact";
import { freshSolid } from "../../model/new_looks";
import { layersOf, scalarsOf } from "../../model/scalars";
import { IconButton, Section } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { IsoCard } from "./iso_card";

export function IsoSection(): JSX.Element {
  const commands = useCommands();
  const scene = useModel((model) => model.scene.value);
  const description = useModel((model) => model.description.value);
  const layers = layersOf(scene, "iso");
  const scalars = scalarsOf(description);
  const add = (): void => {
    const scalar = scalars.find(({ name }) => !layers.some(([, layer]) => layer.array === name)) ?? scalars[0];
    if (scalar === undefined) return;
    commands.layers.add("iso", {
      type: "iso",
      array: scalar.name,
      values: [commands.layers.middleOf(scalar.name)],
      color: freshSolid(scene, "iso"),
    });
  };
  const button = (
    <IconButton icon="plus" label="Add an iso-surface" text="Add" disabled={scalars.length === 0} onClick={add} />
  );
  return (
    <Section title="Iso-surfaces" action={button}>
      {layers.map(([id, layer]) => (
        <IsoCard key={id} id={id} layer={layer} />
      ))}
      {layers.length === 0 && (
        <p class="hint">
          {description !== null && scalars.length === 0
            ? "This dataset has no point array to make a surface from."
            : "None. Add one to see where an array takes a value."}
        </p>
      )}
    </Section>
  );
}
