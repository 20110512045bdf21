// Row of buttons that add a slice or clip plane, perpendicular to an axis or free.
import type { JSX } from "preact";
import { AXES, type Across } from "../../model/axes";
import { IconButton } from "../controls/controls";

interface AddPlaneProps {
  what: "slice" | "clip";
  disabled: boolean;
  add: (across: Across) => void;
}

export function AddPlaneRow({ what, disabled, add }: AddPlaneProps): JSX.Element {
  return (
    <div class="add-row">
      {AXES.map((axis) => (
        <IconButton
          key={axis}
          icon="plus"
          label={`Add a ${what} across ${axis}`}
          text={axis.toUpperCase()}
          disabled={disabled}
          onClick={() => add(axis)}
        />
      ))}
      <IconButton
        icon="plus"
        label={`Add a free ${what} plane`}
        text="Free"
        disabled={disabled}
        onClick={() => add("free")}
      />
    </div>
  );
}
