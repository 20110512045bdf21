import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { arrayOf, shownTime } from "../../model/scalars";
import { useCommands, useModel } from "../context";

/** Histogram of a scalar at the shown time; null until it is known, and if it does not exist at that time. */
export function useDataRange(array: string): Histogram | null {
  const commands = useCommands();
  const scene = useModel((model) => model.scene.value);
  const description = useModel((model) => model.description.value);
  return description === null ? null : commands.histogram(description.name, array, shownTime(description, scene));
}

/** Range of a scalar at the shown time; else the array's range, else [0, 1], so that controls always have one. */
export function useSomeRange(array: string): Range {
  const description = useModel((model) => model.description.value);
  return useDataRange(array)?.range ?? arrayOf(description, array)?.range ?? [0, 1];
}
