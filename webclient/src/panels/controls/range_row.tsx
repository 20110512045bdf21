// Row with the two ends of a range, and a button that resets the range to the range of the data.
import type { ComponentChildren, JSX } from "preact";
import type { Range } from "../../generated/protocol";
import { NumberField } from "./controls";

interface RangeRowProps {
  /** Accessible names: `label` of the row, `from` and `to` of the two numbers. `text` is visible. */
  label: string;
  text: string;
  from: string;
  to: string;
  range: Range;
  /** Width of the range, for the number of digits; undefined for a logarithmic scale. */
  span: number | undefined;
  setEnd: (end: 0 | 1, to: number) => void;
  /** Whether the range follows the data. The Data button calls `setData`; `dataTitle` is its tooltip. */
  ofData: boolean;
  dataTitle: string;
  setData: () => void;
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
