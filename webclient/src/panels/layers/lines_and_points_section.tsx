// Settings of layers that show edges or vertices of the mesh.
import type { ComponentChildren, JSX } from "preact";
import { DEFAULTS, LIMITS, type EdgesLayer, type PointsLayer } from "../../generated/protocol";
import { formatCount } from "../../model/numbers";
import { layersOf } from "../../model/scalars";
import { ColoringFields, OpacityField } from "../color/coloring";
import { IconButton, NumberField, Section, SelectField } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { PatchList } from "./patch_list";
import { RemoveButton } from "../controls/remove_button";
import { ThresholdFields } from "./threshold_fields";

const USUAL_ANGLE = 30;

interface CardProps {
  id: string;
  layer: EdgesLayer | PointsLayer;
  children: ComponentChildren;
}

function Card({ id, layer, children }: CardProps): JSX.Element {
  const commands = useCommands();
  const hasPatches = useModel((model) => (model.description.value?.groups ?? []).some(({ of }) => of === "faces"));
  const visible = layer.visible !== false;
  const title = layer.type === "edges" ? "Edges" : "Points";
  return (
    <article class={visible ? "card" : "card off"} aria-label={title}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={`${visible ? "Hide" : "Show"} these ${layer.type}`}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <span class="card-title">{title}</span>
        <RemoveButton label={`Remove these ${layer.type}`} onClick={() => commands.layers.remove(id)} />
      </div>
      <div class="fields">{children}</div>
      <ColoringFields of={{ layers: [id] }} coloring={layer.color ?? {}} ofPoints />
      <OpacityField id={id} opacity={layer.opacity ?? DEFAULTS.EdgesLayer.opacity} />
      <ThresholdFields id={id} threshold={layer.threshold} color={layer.color?.array} />
      {hasPatches && !(layer.type === "points" && layer.of === "all") && (
        <PatchList
          groups={layer.groups ?? []}
          onChange={(groups) => commands.layers.set(id, { groups: groups ?? [] })}
        />
      )}
    </article>
  );
}

interface SizeProps {
  name: string;
  label: string;
  value: number;
  step: number;
  range: readonly [number, number];
  unit?: string;
  set: (value: number) => void;
}

function SizeField({ name, label, value, step, range, unit, set }: SizeProps): JSX.Element {
  return (
    <label class="field">
      <span>{name}</span>
      <NumberField
        label={label}
        value={value}
        step={step}
        {...(unit !== undefined && { unit })}
        limits={range}
        onChange={set}
      />
    </label>
  );
}

function EdgesCard({ id, layer }: { id: string; layer: EdgesLayer }): JSX.Element {
  const commands = useCommands();
  return (
    <Card id={id} layer={layer}>
      <SelectField
        label="Which"
        value={layer.angle === undefined ? "all" : "features"}
        options={[
          { value: "all", text: "All of the boundary" },
          { value: "features", text: "Where it bends" },
        ]}
        onChange={(which) => commands.layers.set(id, { angle: which === "all" ? null : USUAL_ANGLE })}
      />
      <SizeField
        name="Width"
        label="Width of the lines in pixels"
        value={layer.width ?? DEFAULTS.EdgesLayer.width}
        step={0.5}
        range={[0.1, LIMITS.EdgesLayer.width[1]]}
        unit="px"
        set={(width) => commands.layers.set(id, { width })}
      />
      {layer.angle !== undefined && (
        <SizeField
          name="By more than"
          unit="°"
          label="Angle in degrees"
          value={layer.angle}
          step={5}
          range={LIMITS.EdgesLayer.angle}
          set={(angle) => commands.layers.set(id, { angle })}
        />
      )}
    </Card>
  );
}

function PointsCard({ id, layer }: { id: string; layer: PointsLayer }): JSX.Element {
  const commands = useCommands();
  const vertices = useModel((model) => model.description.value?.mesh.vertices);
  return (
    <Card id={id} layer={layer}>
      <SelectField
        label="Which"
        value={layer.of ?? DEFAULTS.PointsLayer.of}
        options={[
          { value: "boundary", text: "Of the boundary" },
          { value: "all", text: vertices === undefined ? "All" : `All ${formatCount(vertices)}` },
        ]}
        onChange={(of) => commands.layers.set(id, { of, groups: null })}
      />
      <SizeField
        name="Size"
        label="Size of the points in pixels"
        value={layer.size ?? DEFAULTS.PointsLayer.size}
        step={1}
        range={[0.5, LIMITS.PointsLayer.size[1]]}
        unit="px"
        set={(size) => commands.layers.set(id, { size })}
      />
      <SizeField
        name="At most"
        label="Number of points at most"
        value={layer.most ?? DEFAULTS.PointsLayer.most}
        step={DEFAULTS.PointsLayer.most / 10}
        range={LIMITS.PointsLayer.most}
        set={(most) => commands.layers.set(id, { most: Math.round(most) })}
      />
    </Card>
  );
}

export function LinesAndPointsSection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const disabled = useModel((model) => model.description.value === null);
  return (
    <Section title="Lines and points">
      <div class="add-row">
        <IconButton
          icon="plus"
          label="Add edges of the mesh"
          text="Edges"
          disabled={disabled}
          onClick={() => commands.layers.add("edges", { type: "edges", angle: USUAL_ANGLE })}
        />
        <IconButton
          icon="plus"
          label="Add points of the mesh"
          text="Points"
          disabled={disabled}
          onClick={() => commands.layers.add("points", { type: "points" })}
        />
      </div>
      {layersOf(layers, "edges").map(([id, layer]) => (
        <EdgesCard key={id} id={id} layer={layer} />
      ))}
      {layersOf(layers, "points").map(([id, layer]) => (
        <PointsCard key={id} id={id} layer={layer} />
      ))}
    </Section>
  );
}
