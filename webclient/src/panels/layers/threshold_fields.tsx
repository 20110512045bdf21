// Settings of a layer's threshold, which shows only cells with values in a range.
import type { JSX } from "preact";
import { DEFAULTS, type Range, type Threshold } from "../../generated/protocol";
import { formatNumber, fractionOf, valueAt, withEnd } from "../../model/numbers";
import { arrayOf, firstScalar, allScalarsOf } from "../../model/scalars";
import { Check, NumberField, SelectField, Slider } from "../controls/controls";
import { useCommands, useModel, useShownTime } from "../context";

interface ThresholdProps {
  id: string;
  threshold: Threshold | undefined;
  /** Array that colors the layer. A new threshold starts with this array. */
  color: string | undefined;
}

interface EndProps {
  end: 0 | 1;
  range: Range;
  whole: Range;
  set: (change: Partial<Threshold>, gesture?: string) => void;
}

function ThresholdEnd({ end, range, whole, set }: EndProps): JSX.Element {
  const commands = useCommands();
  const value = range[end];
  const span = whole[1] - whole[0];
  const move = (to: number, gesture?: string): void => set({ range: withEnd(range, end, to) }, gesture);
  return (
    <div class="clip-row">
      <Slider
        label={end === 0 ? "Lower end of the threshold" : "Upper end of the threshold"}
        min={0}
        max={1}
        step={0.001}
        value={fractionOf(value, whole)}
        text={formatNumber(value, span)}
        newGesture={() => commands.newGesture()}
        onChange={(fraction, gesture) => move(valueAt(fraction, whole), gesture)} // valueAt() returns the exact ends
      />
      <NumberField
        label={end === 0 ? "Threshold from" : "Threshold to"}
        value={value}
        span={span}
        onChange={(typed) => move(typed)}
      />
    </div>
  );
}

export function ThresholdFields({ id, threshold, color }: ThresholdProps): JSX.Element | null {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const time = useShownTime();
  const scalars = allScalarsOf(description);
  const first = color ?? firstScalar(description) ?? scalars[0]?.name;
  if (first === undefined || description === null) return null;
  const shown = threshold !== undefined && threshold.enabled !== false;
  const wholeOf = (array: string): Range => {
    const known = commands.histogram(description.name, array, time);
    return known?.range ?? arrayOf(description, array)?.range ?? [0, 1];
  };
  const set = (change: Partial<Threshold>, gesture?: string): void =>
    commands.layers.set(id, { threshold: change }, gesture);
  // A new threshold has the upper half of the array's range, because the full range would not change the picture.
  const begin = (array: string): void => {
    const [low, high] = wholeOf(array);
    set({ enabled: true, array, range: [(low + high) / 2, high] });
  };
  const whole = wholeOf(threshold?.array ?? first);
  return (
    <>
      <Check
        label="Threshold"
        checked={shown}
        onChange={(enabled) => (threshold === undefined ? begin(first) : set({ enabled }))}
      />
      {shown && (
        <>
          <div class="fields">
            <SelectField
              label="Cells by"
              value={threshold.array}
              options={scalars.map(({ name }) => ({ value: name, text: name }))}
              onChange={begin}
            />
            {arrayOf(description, threshold.array)?.association !== "cell" && (
              <SelectField
                label="Of their vertices"
                value={threshold.keep ?? DEFAULTS.Threshold.keep}
                options={[
                  { value: "all", text: "all in range" },
                  { value: "any", text: "any in range" },
                ]}
                onChange={(keep) => set({ keep: keep as "all" | "any" })}
              />
            )}
          </div>
          {([0, 1] as const).map((end) => (
            <ThresholdEnd key={end} end={end} range={threshold.range} whole={whole} set={set} />
          ))}
        </>
      )}
    </>
  );
}
