// Slices at right angles to the axes, each with a slider over the dataset's bounds, and free planes.
import type { JSX } from "preact";
import { boundsCentre } from "../camera/camera";
import type { SliceLayer } from "../generated/protocol";
import { clamp, formatNumber, sliderTrack } from "../scene/numbers";
import { firstScalar, layersOf } from "../scene/scalars";
import { ColoringFields, OpacityField } from "./coloring";
import { ContourFields } from "./contour_fields";
import { Check, IconButton, NumberField, Section, Slider } from "./controls";
import { useApp, useAppState } from "./context";
import { EdgesFields } from "./line_fields";
import { PlaneFields } from "./plane_fields";

const AXES = ["x", "y", "z"] as const;
type Axis = (typeof AXES)[number];
type Style = Pick<SliceLayer, "color" | "opacity" | "contours" | "edges">;

/** Of a further slice: as the others are, for their controls are common. */
function useStyle(): Style {
  const description = useAppState((state) => state.description);
  const first = useAppState((state) => layersOf(state.scene, "slice")[0]?.[1]);
  const array = firstScalar(description);
  const { color = array === undefined ? {} : { array }, opacity, contours, edges } = first ?? {};
  return { color, ...(opacity !== undefined && { opacity }), ...(contours && { contours }), ...(edges && { edges }) };
}

function AxisRow({ axis, entry }: { axis: Axis; entry: [string, SliceLayer] | undefined }): JSX.Element {
  const { actions, editor } = useApp();
  const description = useAppState((state) => state.description);
  const at = AXES.indexOf(axis);
  const low = description?.bounds[2 * at] ?? 0;
  const high = description?.bounds[2 * at + 1] ?? 1;
  const shown = entry !== undefined && entry[1].visible !== false;
  const value = entry?.[1].value ?? (low + high) / 2;
  const style = useStyle();
  /** With a position that was typed where no slice is seen: it switches the slice on. */
  const toggle = (on: boolean, typed?: number): void => {
    if (entry === undefined)
      actions.addLayer(`slice-${axis}`, { type: "slice", axis, value: typed ?? value, ...style });
    else actions.setLayer(entry[0], { visible: on, ...(typed !== undefined && { value: typed }) });
  };
  const set = (position: number, gesture?: string): void => {
    if (entry !== undefined) actions.setLayer(entry[0], { value: position }, gesture);
  };
  const units = description?.length_units ?? "";
  const text = (position: number): string => formatNumber(position, high - low);
  return (
    <>
      <div class="axis-row">
        <Check label={axis.toUpperCase()} checked={shown} onChange={(on) => toggle(on)} />
        <Slider
          label={`Position of the ${axis} slice`}
          {...sliderTrack([low, high])}
          value={value}
          text={`${text(value)} ${units}`.trim()}
          disabled={!shown}
          newGesture={() => editor.newGesture()}
          onChange={(position, gesture) => set(clamp(position, low, high), gesture)}
        />
        <NumberField
          label={`Position on ${axis}`}
          value={shown ? value : null}
          span={high - low}
          onChange={(typed) => (shown ? set(typed) : toggle(true, typed))}
        />
      </div>
      {shown && description !== null && (value < low || value > high) && (
        <p class="hint" role="status">
          No slice: {axis} goes from {text(low)} to {text(high)}.
        </p>
      )}
    </>
  );
}

function PlaneCard({ id, layer }: { id: string; layer: SliceLayer }): JSX.Element {
  const { actions } = useApp();
  const visible = layer.visible !== false;
  const name = layer.axis === undefined ? "Free plane" : `Across ${layer.axis} at ${formatNumber(layer.value ?? 0)}`;
  return (
    <article class={visible ? "card" : "card off"} aria-label={`Slice: ${name}`}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Hide this plane" : "Show this plane"}
          pressed={visible}
          onClick={() => actions.setLayer(id, { visible: !visible })}
        />
        <span class="card-title">{name}</span>
        <IconButton icon="close" label="Remove this plane" onClick={() => actions.removeLayer(id)} />
      </div>
      {layer.origin && layer.normal && <PlaneFields id={id} origin={layer.origin} normal={layer.normal} />}
    </article>
  );
}

export function SlicesSection(): JSX.Element {
  const { actions } = useApp();
  const description = useAppState((state) => state.description);
  const style = useStyle();
  const scene = useAppState((state) => state.scene);
  const slices = layersOf(scene, "slice");
  const byAxis = (axis: Axis): [string, SliceLayer] | undefined => slices.find(([, layer]) => layer.axis === axis);
  const shown = slices.filter(([, layer]) => layer.visible !== false);
  const listed = new Set(AXES.map((axis) => byAxis(axis)?.[0]));
  const [first] = shown;
  return (
    <Section title="Slices">
      {AXES.map((axis) => (
        <AxisRow key={axis} axis={axis} entry={byAxis(axis)} />
      ))}
      {slices
        .filter(([id]) => !listed.has(id))
        .map(([id, layer]) => (
          <PlaneCard key={id} id={id} layer={layer} />
        ))}
      <div class="add-row">
        <IconButton
          icon="plus"
          label="Add a free slice plane"
          text="Free plane"
          disabled={description === null}
          onClick={() => {
            if (description === null) return;
            const origin = boundsCentre(description.bounds);
            actions.addLayer("slice", { type: "slice", origin, normal: [1, 1, 0], ...style });
          }}
        />
      </div>
      {first !== undefined && (
        <>
          <ColoringFields of={{ layers: slices.map(([id]) => id) }} coloring={first[1].color ?? {}} />
          <OpacityField layers={slices.map(([id]) => id)} opacity={first[1].opacity ?? 1} />
          <ContourFields slices={slices} first={first[1]} />
          <EdgesFields layers={slices.map(([id]) => id)} edges={first[1].edges} />
        </>
      )}
    </Section>
  );
}
