// Keeps the list of datasets and the description of the scene's dataset up to date.
import { update } from "../model/model";
import type { Core } from "./core";

export async function listDatasets(server: Core): Promise<void> {
  try {
    server.model.datasets.value = await server.session.call("dataset.list", {});
  } catch (error) {
    server.fail(error);
  }
}

export async function describeDataset(server: Core, again = false): Promise<void> {
  const { model } = server;
  const name = model.scene.peek()?.dataset;
  const known = !again && model.description.peek()?.name === name;
  if (name === undefined || !server.editor.isConnected || model.describing.peek() === name || known) return;
  model.describing.value = name;
  try {
    const description = await server.session.call("dataset.describe", { dataset: name });
    if (model.scene.peek()?.dataset === name) update(model, { description });
  } catch (error) {
    server.fail(error);
  } finally {
    if (model.describing.peek() === name) model.describing.value = null;
  }
}
