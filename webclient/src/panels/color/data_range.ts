import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { arrayOf } from "../../model/scalars";
import { useCommands, useModel, useShownTime } from "../context";

/** Returns null until the histogram has arrived, and if the scalar has no values at the shown time. */
export function useDataRange(array: string): Histogram | null {
  const commands = useCommands();
  const time = useShownTime();
  const description = useModel((model) => model.description.value);
  return description === null ? null : commands.histogram(description.name, array, time);
}

/** Until the range at the shown time is known, returns the range over all times, or else [0, 1]. */
export function useSomeRange(array: string): Range {
  const description = useModel((model) => model.description.value);
  return useDataRange(array)?.range ?? arrayOf(description, array)?.range ?? [0, 1];
}
