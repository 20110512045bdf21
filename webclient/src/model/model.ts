// The page's state as Preact signals. Code that reads a signal runs again when the value of the signal changes.
// server/, view/ and commands/ write the signals; panels/ only reads the signals.
import { batch, computed, signal, type ReadonlySignal, type Signal } from "@preact/signals";
import { complete, defaultView, type ViewCamera } from "./camera";
import { openingDataset } from "./opening";
import { stillDue } from "./still_due";
import { initialState, type PageState } from "./state";

type Signals<T> = { readonly [K in keyof T]: Signal<T[K]> };

interface Derived {
  /**
   * Camera of the shown picture; null if its scene has no camera. Also null for polygons, because the page draws
   * polygons with the newest camera.
   */
  readonly shownFrom: ReadonlySignal<ViewCamera | null>;
}

export type Model = Signals<PageState> & Derived;

export function makeModel(saved: Partial<PageState> = {}): Model {
  const entries = Object.entries({ ...initialState, ...saved }).map(([name, value]) => [name, signal(value)]);
  const signals = Object.fromEntries(entries) as Signals<PageState>;
  return { ...signals, ...derivedFrom(signals) };
}

function derivedFrom({ readout, shownScene }: Signals<PageState>): Derived {
  // A separate signal for the stream, so that other changes of the readout do not compute shownFrom again.
  const isImage = computed(() => readout.value.stream === "image");
  return {
    shownFrom: computed(() => {
      const camera = isImage.value ? shownScene.value?.camera : null;
      return camera ? complete(camera) : null;
    }),
  };
}

export function update(model: Model, change: Partial<PageState>): void {
  batch(() => {
    for (const [name, value] of Object.entries(change))
      (model[name as keyof PageState] as Signal<unknown>).value = value;
  });
}

/**
 * Returns the camera of the newest scene. If the scene has no camera, returns the camera that the server chose, or the
 * default view until the server's answer has arrived. null: no scene, or no description of its dataset.
 */
export function cameraOf(model: Model): ViewCamera | null {
  const scene = model.scene.value;
  if (scene === null) return null;
  if (scene.camera) return complete(scene.camera);
  const bounds = model.description.value?.bounds;
  if (model.seenFrom.value?.dataset === scene.dataset) return model.seenFrom.value.camera;
  const { width, height } = model.canvasSize.value;
  return bounds === undefined ? null : defaultView(bounds, width / height);
}

export function openingIn({ chosen, scene, shownScene, fatal, failedRevision }: Model): string | null {
  return openingDataset({
    chosen: chosen.value,
    scene: scene.value,
    shownScene: shownScene.value,
    fatal: fatal.value,
    failedRevision: failedRevision.value,
  });
}

export function isStillDue({ connection, readout, pending, revision, playing, failedRevision }: Model): boolean {
  return stillDue({
    connection: connection.value,
    readout: readout.value,
    pending: pending.value,
    revision: revision.value,
    playing: playing.value,
    failedRevision: failedRevision.value,
  });
}
