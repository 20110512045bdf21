// The mesh itself: the edges of its boundary, its vertices.
import type { JSX } from "preact";
import type { EdgesLayer, PointsLayer } from "../generated/protocol";
import { clamp, formatCount } from "../scene/numbers";
import { layersOf } from "../scene/scalars";
import { ColoringFields, OpacityField } from "./coloring";
import { IconButton, NumberField, Section, SelectField } from "./controls";
import { useApp, useAppState } from "./context";
import { ThresholdFields } from "./threshold_fields";

const USUAL_ANGLE = 30;

function Head({ id, name, visible }: { id: string; name: string; visible: boolean }): JSX.Element {
  const { actions } = useApp();
  return (
    <div class="card-head">
      <IconButton
        icon={visible ? "eye" : "hidden"}
        label={visible ? `Hide these ${name}` : `Show these ${name}`}
        pressed={visible}
        onClick={() => actions.setLayer(id, { visible: !visible })}
      />
      <span class="card-title">{name === "edges" ? "Edges" : "Points"}</span>
      <IconButton icon="close" label={`Remove these ${name}`} onClick={() => actions.removeLayer(id)} />
    </div>
  );
}

function EdgesCard({ id, layer }: { id: string; layer: EdgesLayer }): JSX.Element {
  const { actions } = useApp();
  const visible = layer.visible !== false;
  return (
    <article class={visible ? "card" : "card off"} aria-label="Edges">
      <Head id={id} name="edges" visible={visible} />
      <div class="fields">
        <SelectField
          label="Which"
          value={layer.angle === undefined ? "all" : "features"}
          options={[
            { value: "all", text: "All of the boundary" },
            { value: "features", text: "Where it bends" },
          ]}
          onChange={(which) => actions.setLayer(id, { angle: which === "all" ? null : USUAL_ANGLE })}
        />
        <label class="field">
          <span>Width</span>
          <NumberField
            label="Width of the lines in pixels"
            value={layer.width ?? 1.5}
            step={0.5}
            onChange={(typed) => actions.setLayer(id, { width: clamp(typed, 0.1, 32) })}
          />
        </label>
        {layer.angle !== undefined && (
          <label class="field">
            <span>More than °</span>
            <NumberField
              label="Angle in degrees"
              value={layer.angle}
              step={5}
              onChange={(typed) => actions.setLayer(id, { angle: clamp(typed, 0, 180) })}
            />
          </label>
        )}
      </div>
      <ColoringFields layers={[id]} coloring={layer.color ?? {}} />
      <OpacityField layers={[id]} opacity={layer.opacity ?? 1} />
      <ThresholdFields id={id} threshold={layer.threshold} color={layer.color?.array} />
    </article>
  );
}

function PointsCard({ id, layer }: { id: string; layer: PointsLayer }): JSX.Element {
  const { actions } = useApp();
  const vertices = useAppState((state) => state.description?.mesh.vertices);
  const visible = layer.visible !== false;
  return (
    <article class={visible ? "card" : "card off"} aria-label="Points">
      <Head id={id} name="points" visible={visible} />
      <div class="fields">
        <SelectField
          label="Which"
          value={layer.of ?? "boundary"}
          options={[
            { value: "boundary", text: "Of the boundary" },
            { value: "all", text: vertices === undefined ? "All" : `All ${formatCount(vertices)}` },
          ]}
          onChange={(of) => actions.setLayer(id, { of, groups: null })}
        />
        <label class="field">
          <span>Size</span>
          <NumberField
            label="Size of the points in pixels"
            value={layer.size ?? 4}
            step={1}
            onChange={(typed) => actions.setLayer(id, { size: clamp(typed, 0.5, 64) })}
          />
        </label>
      </div>
      <ColoringFields layers={[id]} coloring={layer.color ?? {}} />
      <OpacityField layers={[id]} opacity={layer.opacity ?? 1} />
      <ThresholdFields id={id} threshold={layer.threshold} color={layer.color?.array} />
    </article>
  );
}

export function LinesAndPointsSection(): JSX.Element {
  const { actions } = useApp();
  const scene = useAppState((state) => state.scene);
  const disabled = useAppState((state) => state.description === null);
  return (
    <Section title="Lines and points">
      <div class="add-row">
        <IconButton
          icon="plus"
          label="Add edges of the mesh"
          text="Edges"
          disabled={disabled}
          onClick={() => actions.addLayer("edges", { type: "edges", angle: USUAL_ANGLE })}
        />
        <IconButton
          icon="plus"
          label="Add points of the mesh"
          text="Points"
          disabled={disabled}
          onClick={() => actions.addLayer("points", { type: "points" })}
        />
      </div>
      {layersOf(scene, "edges").map(([id, layer]) => (
        <EdgesCard key={id} id={id} layer={layer} />
      ))}
      {layersOf(scene, "points").map(([id, layer]) => (
        <PointsCard key={id} id={id} layer={layer} />
      ))}
    </Section>
  );
}
