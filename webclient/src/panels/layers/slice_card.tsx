// Settings of a slice. The fields of the plane are always visible. The fields of the colors and lines can be folded.
import type { JSX } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { DEFAULTS, type SliceLayer } from "../../generated/protocol";
import { endsOf, type Across } from "../../model/axes";
import { formatNumber } from "../../model/numbers";
import { likeThis, looksInWords, planeChange, type Slices } from "../../model/slices";
import { ColoringFields, EmptyHint, OpacityField } from "../color/coloring";
import { ContourFields } from "./contour_fields";
import { IconButton, SelectField } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { Icon } from "../controls/icons";
import { EdgesFields } from "./line_fields";
import { PlaneFields } from "./plane_fields";
import { PositionRow } from "./position_row";
import { RemoveButton } from "../controls/remove_button";

const PLANES = [
  { value: "x", text: "Across x" },
  { value: "y", text: "Across y" },
  { value: "z", text: "Across z" },
  { value: "free", text: "Free plane" },
];

function OutsideHint({ id, layer }: { id: string; layer: SliceLayer }): JSX.Element | null {
  const description = useModel((model) => model.description.value);
  const isFreeOutside = useModel((model) => model.empty.value.some((one) => one.layer === id && one.why === "outside"));
  const { axis, value } = layer;
  if (description === null) return null;
  const [low, high] = axis === undefined ? [0, 0] : endsOf(axis, description.bounds);
  const isOutside = axis === undefined ? isFreeOutside : value !== undefined && (value < low || value > high);
  if (!isOutside) return null;
  const text = (end: number): string => formatNumber(end, high - low);
  return (
    <p class="hint" role="status">
      {axis === undefined
        ? "No slice: the plane lies beside the data."
        : `No slice: ${axis} goes from ${text(low)} to ${text(high)}.`}
    </p>
  );
}

function LooksFields({ id, layer, slices }: { id: string; layer: SliceLayer; slices: Slices }): JSX.Element {
  const commands = useCommands();
  const others = likeThis(slices, id);
  return (
    <>
      <ColoringFields of={{ layers: [id] }} coloring={layer.color ?? {}} />
      <OpacityField id={id} opacity={layer.opacity ?? DEFAULTS.SliceLayer.opacity} />
      <ContourFields id={id} slice={layer} />
      <EdgesFields id={id} edges={layer.edges} />
      {slices.length > 1 && (
        <button
          type="button"
          class="button small all-alike"
          title="Gives all slices these colors, this opacity, these contour lines and edges"
          disabled={Object.keys(others).length === 0}
          onClick={() => commands.layers.setAll(others)}
        >
          All slices like this one
        </button>
      )}
    </>
  );
}

interface SliceCardProps {
  id: string;
  layer: SliceLayer;
  name: string;
  slices: Slices;
  isOpen: boolean;
  fold: () => void;
  /** Returns true once for a new slice. The slice's slider then gets the focus, so that keys move the slice at once. */
  takesFocus: () => boolean;
}

export function SliceCard({ id, layer, name, slices, isOpen, fold, takesFocus }: SliceCardProps): JSX.Element {
  const commands = useCommands();
  const bounds = useModel((model) => model.description.value?.bounds);
  const root = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    if (takesFocus()) root.current?.querySelector<HTMLElement>("input[type=range]")?.focus();
  }, []);
  const visible = layer.visible !== false;
  const { axis, value, origin, normal } = layer;
  const layAcross = (across: string): void => {
    if (bounds !== undefined) commands.layers.set(id, planeChange(slices, layer, across as Across, bounds));
  };
  return (
    <article class={visible ? "card" : "card off"} aria-label={name} ref={root}>
      <div class="card-head">
        <IconButton
          icon={visible ? "eye" : "hidden"}
          label={visible ? "Hide this slice" : "Show this slice"}
          pressed={visible}
          onClick={() => commands.layers.set(id, { visible: !visible })}
        />
        <SelectField
          label="Plane of the slice"
          hideLabel
          value={axis ?? "free"}
          options={PLANES}
          onChange={layAcross}
        />
        <RemoveButton label="Remove this slice" onClick={() => commands.layers.remove(id)} />
      </div>
      {axis !== undefined && (
        <PositionRow
          id={id}
          axis={axis}
          value={value}
          labels={[`Position of the ${axis} slice`, `Position on ${axis}`]}
        />
      )}
      {origin && normal && <PlaneFields id={id} origin={origin} normal={normal} />}
      <OutsideHint id={id} layer={layer} />
      <button type="button" class="card-fold" aria-expanded={isOpen} onClick={fold}>
        <Icon name="chevron" />
        <span>Looks</span>
        {!isOpen && <small>{looksInWords(layer)}</small>}
      </button>
      {isOpen ? <LooksFields id={id} layer={layer} slices={slices} /> : <EmptyHint id={id} />}
    </article>
  );
}
