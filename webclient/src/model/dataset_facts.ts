// Summary of a dataset in words: cells, steps, arrays, size.
import type { DatasetDescription } from "../generated/protocol";
import { formatCount, formatNumber } from "./numbers";

const NO_BREAK = "\u00a0";

const counted = (count: number, one: string): string => `${formatCount(count)} ${one}${count === 1 ? "" : "s"}`;

export function datasetFacts({
  mesh,
  times,
  unread_steps: unread,
  arrays,
  bounds,
  length_units,
}: DatasetDescription): string[] {
  const cells = Object.values(mesh.cells).reduce((sum, count) => sum + count, 0);
  const sides = [0, 2, 4].map((low) => formatNumber((bounds[low + 1] ?? 0) - (bounds[low] ?? 0)));
  return [
    counted(cells, "cell"),
    counted(times.length, "time step") + (unread === undefined ? "" : ` (${formatCount(unread)} not read yet)`),
    counted(arrays.length, "array"),
    `${sides.join(" \u00d7 ")} ${length_units}`.trim().replaceAll(" ", NO_BREAK),
  ];
}
