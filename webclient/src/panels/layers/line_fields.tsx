// Fields for lines of a layer: visibility, color, width.
import type { JSX } from "preact";
import { DEFAULTS, LIMITS, type Edges } from "../../generated/protocol";
import { Check, NumberField } from "../controls/controls";
import { useCommands } from "../context";

interface LineStyleProps {
  label: string;
  /** Color of the lines; null if an array colors them. */
  color: string | null;
  width: number;
  onChange: (change: { color?: string; width?: number }) => void;
}

export function LineStyleFields({ label, color, width, onChange }: LineStyleProps): JSX.Element {
  return (
    <div class="fields">
      {color !== null && (
        <label class="field">
          <span>Color</span>
          <input
            type="color"
            aria-label={`Color of ${label}`}
            value={color}
            onChange={(event) => onChange({ color: event.currentTarget.value })}
          />
        </label>
      )}
      <label class="field">
        <span>Width</span>
        <NumberField
          label={`Width of ${label} in pixels`}
          value={width}
          step={0.5}
          unit="px"
          limits={[0.1, LIMITS.Edges.width[1]]}
          onChange={(typed) => onChange({ width: typed })}
        />
      </label>
    </div>
  );
}

export function EdgesFields({ id, edges }: { id: string; edges: Edges | undefined }): JSX.Element {
  const commands = useCommands();
  const shown = edges !== undefined && edges.visible !== false;
  const set = (change: Edges): void => commands.layers.set(id, { edges: change });
  return (
    <>
      <Check label="Cell edges" checked={shown} onChange={(visible) => set({ visible })} />
      {shown && (
        <LineStyleFields
          label="the edges"
          color={edges.color ?? DEFAULTS.Edges.color}
          width={edges.width ?? DEFAULTS.Edges.width}
          onChange={set}
        />
      )}
    </>
  );
}
