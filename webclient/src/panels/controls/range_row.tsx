// The two ends of a range, and the button that gives it back to the data.
import type { ComponentChildren, JSX } from "preact";
import type { Range } from "../../generated/protocol";
import { NumberField } from "./controls";

interface RangeRowProps {
  /** Of the whole, and of its two numbers. */
  label: string;
  text: string;
  from: string;
  to: string;
  range: Range;
  /** How many digits are worth showing; none for a logarithmic scale, whose numbers have their own. */
  span: number | undefined;
  /** 0: the lower end. */
  setEnd: (end: 0 | 1, to: number) => void;
  /** Whether the range is the data's, and what makes it so. */
  ofData: boolean;
  dataTitle: string;
  setData: () => void;
  /** Further buttons. */
  children?: ComponentChildren;
}

export function RangeRow(props: RangeRowProps): JSX.Element {
  const { label, text, from, to, range, span, setEnd, ofData, dataTitle, setData, children } = props;
  return (
    <div class="field" role="group" aria-label={label}>
      <span>{text}</span>
      <div class="range-row">
        <NumberField label={from} value={range[0]} span={span} onChange={(low) => setEnd(0, low)} />
        <NumberField label={to} value={range[1]} span={span} onChange={(high) => setEnd(1, high)} />
      </div>
      <div class="range-choices">
        <button type="button" class="button small" aria-pressed={ofData} title={dataTitle} onClick={setData}>
          Data
        </button>
        {children}
      </div>
    </div>
  );
}
