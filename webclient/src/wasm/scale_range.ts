// Ranges of color scales, computed by the code of server/color/scale_range.hpp.
import type { Coloring, Range } from "../generated/protocol";
import { call } from "./layout_module";
import type { Item, ResultReader } from "./message";

const choiceItem = ({ range, symmetric = false, log = false }: Coloring): Item => [
  range ? [1, range] : 0,
  symmetric,
  log,
];

const ends = (results: ResultReader): Range => [results.number(), results.number()];

/** `data`: range of the array at the shown time step. */
export const rangeOf = (coloring: Coloring, data: Range): Range => ends(call("range_of", choiceItem(coloring), data));

/** Returns the range limited to values that a logarithmic scale can show, or any valid range if there are none. */
export const rangeAboveZero = (range: Range): Range => ends(call("range_above_zero", range));

/** Returns false for a logarithmic scale that takes its range from the data, if no data value is above zero. */
export const isShownBy = (coloring: Coloring, data: Range): boolean =>
  call("is_shown_by", choiceItem(coloring), data).number() !== 0;
