// A dataset that was chosen and is not seen yet. Until its first picture, no number of the dataset before may be read as
// one of it.
import type { Scene } from "../generated/protocol";
import type { PageState } from "./state";

type Opening = Pick<PageState, "chosen" | "scene" | "shownDataset" | "fatal" | "failedRevision">;

/** Its name; null where the picture is of the scene's dataset, or the server cannot draw one. */
export function openingDataset({ chosen, scene, shownDataset, fatal, failedRevision }: Opening): string | null {
  if (chosen !== null || scene === null || fatal !== null || failedRevision !== null) return chosen;
  return scene.dataset === shownDataset ? null : scene.dataset;
}

/** What was said about the dataset before, and does not hold for the scene's. */
export function forgottenWith(state: Readonly<PageState>, scene: Scene | null): Partial<PageState> {
  if (scene === null || scene.dataset === state.scene?.dataset) return {};
  const description = state.upcoming?.name === scene.dataset ? state.upcoming : null;
  return { description, upcoming: null, probe: null, lacking: [], empty: [], missing: [], failedRevision: null };
}
