// Row of number fields for the three coordinates of a vector.
import type { JSX } from "preact";
import type { Vec3 } from "../../generated/protocol";
import { AXES } from "../../model/axes";
import { NumberField } from "./controls";

interface VectorProps {
  label: string;
  value: Vec3;
  /** Size of the region that the coordinates are in. It determines the number of digits. */
  span: number;
  set: (to: Vec3) => void;
}

export function VectorRow({ label, value, span, set }: VectorProps): JSX.Element {
  return (
    <div class="vector-row">
      <span>{label}</span>
      {AXES.map((axis, at) => (
        <NumberField
          key={axis}
          label={`${label} ${axis}`}
          value={value[at] ?? 0}
          span={span}
          onChange={(typed) => set(value.map((old, i) => (i === at ? typed : old)) as Vec3)}
        />
      ))}
    </div>
  );
}
