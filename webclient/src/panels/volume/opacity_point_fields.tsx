// Number fields for position and opacity of the selected point of an opacity curve.
import type { JSX } from "preact";
import type { Range } from "../../generated/protocol";
import { fractionOf, valueAt } from "../../model/numbers";
import type { OpacityPoint } from "../../model/opacity";
import { NumberField } from "../controls/controls";

interface Props {
  index: number;
  point: OpacityPoint;
  /** Positions of the two neighboring points, which limit the point's position. */
  between: Range;
  range: Range;
  logarithmic: boolean;
  units: string;
  set: (to: OpacityPoint) => void;
}

export function OpacityPointFields({ index, point, between, range, logarithmic, units, set }: Props): JSX.Element {
  const [position, opacity] = point;
  const name = `opacity point ${index + 1}`;
  return (
    <div class="opacity-fields">
      <span>Point {index + 1} at</span>
      <NumberField
        label={`Value of ${name}`}
        value={valueAt(position, range, logarithmic)}
        span={logarithmic ? undefined : range[1] - range[0]}
        limits={[valueAt(between[0], range, logarithmic), valueAt(between[1], range, logarithmic)]}
        onChange={(typed) => set([fractionOf(typed, range, logarithmic), opacity])}
      />
      <span>{units} is</span>
      <NumberField
        label={`Opacity of ${name} in percent`}
        value={Number((100 * opacity).toFixed(2))}
        step={5}
        limits={[0, 100]}
        onChange={(typed) => set([position, typed / 100])}
      />
      <span>% opaque</span>
    </div>
  );
}
