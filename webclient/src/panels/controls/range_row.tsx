// The two ends of a range, and a button that resets it to the data's range.
import type { ComponentChildren, JSX } from "preact";
import type { Range } from "../../generated/protocol";
import { NumberField } from "./controls";

interface RangeRowProps {
  /** Accessible name of the row. `text` is its visible label; `from` and `to` name the two numbers. */
  label: string;
  text: string;
  from: string;
  to: string;
  range: Range;
  /** Determines the number of digits; undefined for a logarithmic scale, where each number has its own. */
  span: number | undefined;
  /** 0: the lower end. */
  setEnd: (end: 0 | 1, to: number) => void;
  /** Whether the range follows the data. `dataTitle` and `setData` belong to the button that makes it so. */
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
