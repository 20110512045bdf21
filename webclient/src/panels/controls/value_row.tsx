// Row of values of an array. Each value can be edited and removed. A new value is placed in the widest gap.
import type { JSX } from "preact";
import { LIMITS, type Range } from "../../generated/protocol";
import { niceStep, widestGap } from "../../model/numbers";
import { IconButton, NumberField } from "./controls";
import { RemoveButton } from "./remove_button";

const [, MOST_VALUES] = LIMITS.IsoLayer.values; // Contours.values has the same limit

export function replaced(values: readonly number[], index: number, value: number): number[] {
  return values.map((old, i) => (i === index ? value : old));
}

interface ValueRowProps {
  values: readonly number[];
  range: Range;
  setValues: (values: number[]) => void;
  /** `alone`: label of a single value. `numbered`: start of the label of each of several values; its number follows. */
  alone: string;
  numbered: string;
  children?: JSX.Element;
}

export function ValueRow({ values, range, setValues, alone, numbered, children }: ValueRowProps): JSX.Element {
  const span = range[1] - range[0];
  return (
    <div class="values" data-list="">
      {values.map((value, index) => (
        <span class="value" key={index}>
          <NumberField
            label={values.length > 1 ? `${numbered} ${index + 1}` : alone}
            value={value}
            span={span}
            step={niceStep(range) * 10}
            onChange={(typed) => setValues(replaced(values, index, typed))}
          />
          {values.length > 1 && (
            <RemoveButton
              label={`Remove ${numbered.toLowerCase()} ${index + 1}`}
              onClick={() => setValues(values.filter((_, i) => i !== index))}
            />
          )}
        </span>
      ))}
      {values.length < MOST_VALUES && (
        <IconButton
          icon="plus"
          label={`Add a ${numbered.toLowerCase()}`}
          onClick={() => setValues([...values, widestGap(values, range)])}
        />
      )}
      {children}
    </div>
  );
}
