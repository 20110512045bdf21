import type { Histogram } from "../../model/state";
import type { Range } from "../../generated/protocol";
import { arrayOf, shownTime } from "../../model/scalars";
import { useCommands, useModel } from "../context";

/** Of a scalar at the shown time, as soon as it is known; until then and where it was not written, null. */
export function useDataRange(array: string): Histogram | null {
  const commands = useCommands();
  const scene = useModel((model) => model.scene.value);
  const description = useModel((model) => model.description.value);
  return description === null ? null : commands.histogram(description.name, array, shownTime(description, scene));
}

/** The same, or what is nearest to it: a range that controls can work with at any time. */
export function useSomeRange(array: string): Range {
  const description = useModel((model) => model.description.value);
  return useDataRange(array)?.range ?? arrayOf(description, array)?.range ?? [0, 1];
}
