// Commands for the colorings of layers and contour lines.
import { withLog, type ColoringChange } from "../model/color_edit";
import type { Json, JsonObject } from "../model/merge_patch";
import { sameDataset } from "../model/opening";
import { percentiles } from "../model/percentiles";
import { coloredBy } from "../model/new_looks";
import { shownTime, type Colored } from "../model/scalars";
import type { Coloring, Range } from "../generated/protocol";
import type { Deps } from "./deps";

const USUAL_SHARES = [0.01, 0.99] as const;
const USUAL_BINS = 1024;

export class ColorCommands {
  /** Colorings before the logarithmic scale was switched on. Key: the layers and contour lines as JSON text. */
  private readonly beforeLog = new Map<string, Coloring>();

  constructor(private readonly deps: Deps) {}

  set({ layers, contours = [] }: Colored, change: ColoringChange, gesture?: string): void {
    const color: JsonObject = {};
    for (const [key, value] of Object.entries(change)) color[key] = (value ?? null) as unknown as Json;
    const patch: JsonObject = Object.fromEntries(layers.map((id) => [id, { color }]));
    this.deps.model.touched.value = layers.at(-1) ?? contours.at(-1) ?? null;
    for (const id of contours) patch[id] = { ...(patch[id] as JsonObject | undefined), contours: { coloring: color } };
    this.deps.server.editor.change({ layers: patch }, gesture);
  }

  setLog(of: Colored, coloring: Coloring, on: boolean): void {
    const key = JSON.stringify(of);
    this.set(of, withLog(coloring, on, this.beforeLog.get(key)));
    if (on) this.beforeLog.set(key, coloring);
    else this.beforeLog.delete(key);
  }

  /** If `array` is null, the layers get one color. */
  by(of: Colored, array: string | null): void {
    const { description, scene } = this.deps.model;
    if (array === null) this.set(of, { array: undefined, range: undefined });
    else this.set(of, { range: undefined, ...coloredBy(scene.peek(), description.peek(), array) });
  }

  /**
   * Returns the range between the percentiles of USUAL_SHARES at the shown time. Returns null if there are no values,
   * the call fails, or another dataset is chosen meanwhile.
   */
  async usualRange(array: string): Promise<Range | null> {
    const { model, server } = this.deps;
    const description = model.description.peek();
    if (description === null) return null;
    const time = shownTime(description, model.scene.peek());
    const isCurrent = sameDataset(model);
    const asked = { dataset: description.name, array, time, bins: USUAL_BINS };
    try {
      const range = await percentiles(
        (range) => server.session.call("dataset.histogram", { ...asked, ...(range !== null && { range }) }),
        USUAL_SHARES,
      );
      return isCurrent() ? range : null;
    } catch (error) {
      if (isCurrent()) this.deps.unanswered(error, "The range of most values cannot be computed");
      return null;
    }
  }

  /**
   * Returns the range of the values in view. If there are none or the call fails, tells the user and returns null. Also
   * returns null if another dataset is chosen meanwhile.
   */
  async rangeInView(colored: Colored): Promise<Range | null> {
    const { model, server } = this.deps;
    const isCurrent = sameDataset(model);
    const of = async (use: keyof Colored): Promise<Range[]> => {
      const layers = colored[use] ?? [];
      if (layers.length === 0) return [];
      const asked = { session: server.tab.id, layers, aspect: server.size.aspect, of: use };
      const { range } = await server.session.call("color.range", asked);
      return range === null ? [] : [range];
    };
    try {
      const ranges = [...(await of("layers")), ...(await of("contours"))];
      if (!isCurrent()) return null;
      if (ranges.length > 0)
        return [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))];
      this.deps.tell("No value of these layers is in view; move the layers into view and try again", "error");
      return null;
    } catch (error) {
      if (isCurrent()) this.deps.unanswered(error, "The range in view cannot be computed");
      return null;
    }
  }
}
