// Row with the two ends of a range, and a button that resets the range to the range of the data.
import type { ComponentChildren, JSX } from "preact";
import type { Range } from "../../generated/protocol";
import { NumberField } from "./controls";

interface RangeRowProps {
  /**
   * Accessible name of the row. `text` is the visible label. `from` and `to` are the accessible names of the two
   * numbers.
   */
  label: string;
  text: string;
  from: string;
  to: string;
  range: Range;
  /**
   * Width of the range. It determines the number of digits. undefined for a logarithmic scale, where the number of
   * digits depends on the number itself.
   */
  span: number | undefined;
  /** Sets one end of the range; 0: the lower end. */
  setEnd: (end: 0 | 1, to: number) => void;
  /**
   * Whether the range follows the data. A button calls `setData`, which makes the range follow the data again.
   * `dataTitle` is the tooltip of this button.
   */
  ofData: boolean;
  dataTitle: string;
  setData: () => void;
  /** Additional buttons at the end of the row. */
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
