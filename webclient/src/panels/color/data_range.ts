import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { arrayOf } from "../../model/scalars";
import { useCommands, useModel, useShownTime } from "../context";

/**
 * Returns the histogram of a scalar at the shown time. Returns null until the histogram has arrived, and also if the
 * scalar has no values at that time.
 */
export function useDataRange(array: string): Histogram | null {
  const commands = useCommands();
  const time = useShownTime();
  const description = useModel((model) => model.description.value);
  return description === null ? null : commands.histogram(description.name, array, time);
}

/**
 * Returns the range of a scalar at the shown time. Until this range is known, returns the array's range over all times,
 * or [0, 1] if that is unknown too.
 */
export function useSomeRange(array: string): Range {
  const description = useModel((model) => model.description.value);
  return useDataRange(array)?.range ?? arrayOf(description, array)?.range ?? [0, 1];
}
