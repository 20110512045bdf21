// State of the page between the choice of a dataset and the first picture of this dataset. In this time, the page must
// not show numbers of the previous dataset.
import type { Scene } from "../generated/protocol";
import type { PageState } from "./state";

type Opening = Pick<PageState, "chosen" | "scene" | "shownScene" | "fatal" | "failedRevision">;

/**
 * Returns the name of the dataset that is being opened. Returns null if the picture already shows this dataset, or if
 * the server cannot draw the scene.
 */
export function openingDataset({ chosen, scene, shownScene, fatal, failedRevision }: Opening): string | null {
  if (chosen !== null || scene === null || fatal !== null || failedRevision !== null) return chosen;
  return scene.dataset === shownScene?.dataset ? null : scene.dataset;
}

/**
 * Call before a request to the server. The returned function returns false if the scene has another dataset by then.
 * The answer is then about the previous dataset and must be ignored.
 */
export function sameDataset({ scene }: { scene: { peek(): Scene | null } }): () => boolean {
  const asked = scene.peek()?.dataset;
  return () => scene.peek()?.dataset === asked;
}

/** Returns the changes that clear all state of the previous dataset. Returns {} if the dataset stays the same. */
export function forgottenWith(state: Pick<PageState, "scene" | "upcoming">, scene: Scene | null): Partial<PageState> {
  if (scene === null || scene.dataset === state.scene?.dataset) return {};
  const description = state.upcoming?.name === scene.dataset ? state.upcoming : null;
  return { description, upcoming: null, probe: null, lacking: [], empty: [], missing: [], failedRevision: null };
}
