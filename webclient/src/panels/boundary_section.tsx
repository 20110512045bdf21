// The mesh's boundary: the whole of it, or its named patches.
import type { JSX } from "preact";
import { formatCount } from "../scene/numbers";
import { layersOf } from "../scene/scalars";
import { ColoringFields, OpacityField } from "./coloring";
import { Check, Section } from "./controls";
import { useApp, useAppState } from "./context";
import { EdgesFields } from "./line_fields";
import { ThresholdFields } from "./threshold_fields";

export function BoundarySection(): JSX.Element {
  const { actions } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  const [entry] = layersOf(scene, "surface");
  const patches = (description?.groups ?? []).filter(({ of }) => of === "faces");
  const layer = entry?.[1];
  const shown = layer !== undefined && layer.visible !== false;
  const groups = layer?.groups ?? [];
  const whole = shown && groups.length === 0;

  const show = (names: string[] | null): void => {
    if (entry === undefined) {
      if (names !== null) actions.addLayer("surface", { type: "surface", groups: names });
    } else if (names === null) actions.setLayer(entry[0], { visible: false });
    else actions.setLayer(entry[0], { visible: true, groups: names });
  };
  const togglePatch = (name: string, on: boolean): void => {
    const before = shown && !whole ? groups : [];
    const next = on ? [...before, name] : before.filter((group) => group !== name);
    show(next.length === 0 ? null : next);
  };
  return (
    <Section title="Boundary">
      <Check
        label="Whole boundary"
        detail={description === null ? undefined : `${formatCount(description.mesh.boundary_faces)} faces`}
        checked={whole}
        onChange={(on) => show(on ? [] : null)}
      />
      {patches.map(({ name, count }) => (
        <Check
          key={name}
          label={name}
          detail={`${formatCount(count)} faces`}
          checked={shown && groups.includes(name)}
          onChange={(on) => togglePatch(name, on)}
        />
      ))}
      {entry !== undefined && shown && (
        <>
          <ColoringFields layers={[entry[0]]} coloring={entry[1].color ?? {}} />
          <OpacityField layers={[entry[0]]} opacity={entry[1].opacity ?? 1} />
          <ThresholdFields id={entry[0]} threshold={entry[1].threshold} color={entry[1].color?.array} />
          <EdgesFields layers={[entry[0]]} edges={entry[1].edges} />
        </>
      )}
    </Section>
  );
}
