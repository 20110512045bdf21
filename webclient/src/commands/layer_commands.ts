// Commands for layers, their order, and the patches of a boundary.
import { movedTo } from "../model/layer_order";
import { patchesOf, withNone } from "../model/patches";
import { arrayOf, freeId, shownTime, topOrder } from "../model/scalars";
import type { Layer, Scene } from "../generated/protocol";
import type { Deps } from "./deps";

export class LayerCommands {
  constructor(private readonly deps: Deps) {}

  set(id: string, change: object, gesture?: string): void {
    this.deps.model.touched.value = id;
    this.deps.server.editor.change({ layers: { [id]: change } }, gesture);
  }

  setAll(layers: Record<string, object>): void {
    this.deps.server.editor.change({ layers });
  }

  remove(id: string): void {
    this.deps.server.editor.change({ layers: { [id]: null } });
  }

  move(id: string, place: number): void {
    const scene = this.scene();
    const layers = scene === null ? null : movedTo(scene, id, place);
    if (layers !== null) this.deps.server.editor.change({ layers });
  }

  add(prefix: string, layer: Layer): string | null {
    const scene = this.scene();
    if (scene === null) return null;
    const id = freeId(scene, prefix);
    this.deps.model.touched.value = id;
    this.deps.server.editor.change({ layers: { [id]: { ...layer, order: topOrder(scene) } } });
    return id;
  }

  /** Returns the middle of the array's range at the shown time, or over all times until the histogram has arrived. */
  middleOf(array: string): number {
    const { model, server } = this.deps;
    const description = model.description.peek();
    const time = shownTime(description, model.scene.peek());
    const known = description === null ? null : server.histograms.get(description.name, array, time);
    const [low, high] = known?.range ?? arrayOf(description, array)?.range ?? [0, 1];
    return (low + high) / 2;
  }

  hidePatch(id: string, patch: string): void {
    const layer = this.scene()?.layers?.[id];
    if (layer?.type !== "surface") return;
    const all = patchesOf(this.deps.model.description.peek());
    const left = withNone(
      all,
      layer.groups ?? [],
      all.filter(({ name }) => name === patch),
    );
    this.set(id, left === null ? { visible: false } : { groups: left });
    this.deps.model.probe.value = null;
  }

  onlyPatch(id: string, patch: string): void {
    if (this.scene()?.layers?.[id]?.type === "surface") this.set(id, { groups: [patch] });
  }

  private scene(): Scene | null {
    return this.deps.model.scene.peek();
  }
}
