// A chosen dataset before its first picture. Until then, no number of the previous dataset may be taken for one of the
// new dataset.
import type { Scene } from "../generated/protocol";
import type { PageState } from "./state";

type Opening = Pick<PageState, "chosen" | "scene" | "shownDataset" | "fatal" | "failedRevision">;

/** Name of the dataset that is opening; null if the picture shows the scene's dataset or the server cannot draw. */
export function openingDataset({ chosen, scene, shownDataset, fatal, failedRevision }: Opening): string | null {
  if (chosen !== null || scene === null || fatal !== null || failedRevision !== null) return chosen;
  return scene.dataset === shownDataset ? null : scene.dataset;
}

/** State change that clears what belongs to the previous dataset; {} if `scene` has the same dataset. */
export function forgottenWith(state: Pick<PageState, "scene" | "upcoming">, scene: Scene | null): Partial<PageState> {
  if (scene === null || scene.dataset === state.scene?.dataset) return {};
  const description = state.upcoming?.name === scene.dataset ? state.upcoming : null;
  return { description, upcoming: null, probe: null, lacking: [], empty: [], missing: [], failedRevision: null };
}
