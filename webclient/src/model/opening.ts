// Until the first picture of a chosen dataset, the page must not show numbers of the previous dataset.
import type { Scene } from "../generated/protocol";
import type { Model } from "./model";
import type { PageState } from "./state";

type Opening = Pick<PageState, "chosen" | "scene" | "shownScene" | "fatal" | "failedRevision">;

/** Returns null if the picture already shows the scene's dataset, or if the server cannot draw the scene. */
export function openingDataset({ chosen, scene, shownScene, fatal, failedRevision }: Opening): string | null {
  if (chosen !== null || scene === null || fatal !== null || failedRevision !== null) return chosen;
  return scene.dataset === shownScene?.dataset ? null : scene.dataset;
}

/**
 * Returns a function that tells whether the scene still has the dataset that it has now. Answers that come later are
 * about another dataset.
 */
export function sameDataset({ scene }: Pick<Model, "scene">): () => boolean {
  const asked = scene.peek()?.dataset;
  return () => scene.peek()?.dataset === asked;
}

/** Clears everything about the previous dataset. Returns {} if `scene` has the same dataset. */
export function forgottenWith(state: Pick<PageState, "scene" | "upcoming">, scene: Scene | null): Partial<PageState> {
  if (scene === null || scene.dataset === state.scene?.dataset) return {};
  const description = state.upcoming?.name === scene.dataset ? state.upcoming : null;
  return { description, upcoming: null, probe: null, lacking: [], empty: [], missing: [], failedRevision: null };
}
