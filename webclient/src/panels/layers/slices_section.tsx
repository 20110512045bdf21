// Settings of all slices. Several slices may be perpendicular to the same axis.
import type { JSX } from "preact";
import { useRef, useState } from "preact/hooks";
import type { Across } from "../../model/axes";
import { layerNames } from "../../model/layer_names";
import { coloredBy, freshArray } from "../../model/new_looks";
import { layersOf } from "../../model/scalars";
import { furtherSlice } from "../../model/slices";
import { AddPlaneRow } from "./add_plane_row";
import { Section } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { SliceCard } from "./slice_card";

export function SlicesSection(): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const layers = useLayers();
  // null at first: only the first slice is unfolded, so that the positions of all slices are visible.
  const [opened, setOpened] = useState<readonly string[] | null>(null);
  const first = useRef<string | undefined>(undefined);
  const added = useRef<string | null>(null);
  const slices = layersOf(layers, "slice");
  const names = layerNames(layers);
  if (!slices.some(([id]) => id === first.current)) first.current = slices[0]?.[0]; // kept while this slice exists
  const open = opened ?? slices.flatMap(([id]) => (id === first.current ? [id] : []));
  const add = (across: Across): void => {
    if (description === null) return;
    const array = freshArray(layers, description);
    const color = array === undefined ? {} : coloredBy(layers, description, array);
    const slice = furtherSlice(slices, across, description.bounds, color);
    added.current = commands.layers.add(across === "free" ? "slice" : `slice-${across}`, slice);
    if (added.current !== null) setOpened([added.current]);
  };
  const takesFocus = (id: string): boolean => {
    const isNew = added.current === id;
    if (isNew) added.current = null;
    return isNew;
  };
  return (
    <Section title="Slices">
      <AddPlaneRow what="slice" disabled={description === null} add={add} />
      {slices.map(([id, layer]) => (
        <SliceCard
          key={id}
          id={id}
          layer={layer}
          name={names.get(id) ?? id}
          slices={slices}
          isOpen={open.includes(id)}
          fold={() => setOpened(open.includes(id) ? open.filter((other) => other !== id) : [...open, id])}
          takesFocus={() => takesFocus(id)}
        />
      ))}
      {slices.length === 0 && (
        <p class="hint">None. A slice shows the data in a plane, which can be moved through it.</p>
      )}
    </Section>
  );
}
