// Texts about the cells with the lowest and highest value of a cell array. A point array that is interpolated from the
// cell array does not reach these values.
import type { CellExtreme, CellExtremes } from "../generated/protocol";
import { formatNumber } from "./numbers";

export const cellsText = ({ lowest, highest }: CellExtremes): string =>
  `cells: ${formatNumber(lowest.value)} to ${formatNumber(highest.value)}`;

export const extremeText = ({ value, cell, place }: CellExtreme): string =>
  `${formatNumber(value)} in cell ${cell} at (${place.map((x) => formatNumber(x)).join(", ")})`;

export const extremesText = ({ lowest, highest }: CellExtremes): string =>
  `Lowest ${extremeText(lowest)}; highest ${extremeText(highest)}`;
