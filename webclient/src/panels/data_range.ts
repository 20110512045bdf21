import type { Histogram } from "../app/state";
import type { Range } from "../generated/protocol";
import { arrayOf, shownTime } from "../scene/scalars";
import { useApp, useAppState } from "./context";

/** Of a scalar at the shown time, as soon as it is known; until then and where it was not written, null. */
export function useDataRange(array: string): Histogram | null {
  const { histograms } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  useAppState((state) => state.histogramsAt);
  return description === null ? null : histograms.get(description.name, array, shownTime(description, scene));
}

/** The same, or what is nearest to it: a range that controls can work with at any time. */
export function useSomeRange(array: string): Range {
  const description = useAppState((state) => state.description);
  return useDataRange(array)?.range ?? arrayOf(description, array)?.range ?? [0, 1];
}
