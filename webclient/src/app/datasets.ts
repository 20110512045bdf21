// Keeps the description of the scene's dataset at hand.
import type { App } from "./app";

export async function listDatasets(app: App): Promise<void> {
  try {
    app.store.set({ datasets: await app.session.call("dataset.list", {}) });
  } catch (error) {
    app.fail(error);
  }
}

/** Fetches the description when the scene's dataset is another one than the described. */
export async function describeDatasets(app: App, again = false): Promise<void> {
  const { scene, description, describing } = app.store.get();
  const name = scene?.dataset;
  if (name === undefined || !app.editor.isConnected || describing === name || (!again && description?.name === name))
    return;
  app.store.set({ describing: name });
  try {
    const found = await app.session.call("dataset.describe", { dataset: name });
    if (app.store.get().scene?.dataset === name) app.store.set({ description: found });
    app.viewport?.redraw();
  } catch (error) {
    app.fail(error);
  } finally {
    if (app.store.get().describing === name) app.store.set({ describing: null });
  }
}
