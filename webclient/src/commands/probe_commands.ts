import { sameDataset } from "../model/opening";
import { probeText } from "../model/probe_text";
import { unitsOf } from "../model/scalars";
import type { Vec3 } from "../generated/protocol";
import { copyText } from "./clipboard";
import type { Deps } from "./deps";

export class ProbeCommands {
  constructor(private readonly deps: Deps) {}

  /**
   * (x, y) is in CSS pixels of the canvas. Returns null if nothing is drawn there, undefined if the call failed or
   * another dataset was chosen meanwhile.
   */
  async at(x: number, y: number): Promise<Vec3 | null | undefined> {
    const { model, server } = this.deps;
    const { width, height } = server.size.pixels();
    const ratio = width / server.size.css.width;
    const isCurrent = sameDataset(model);
    const asked = { session: server.tab.id, pixel: [x * ratio, y * ratio] as [number, number], width, height };
    try {
      const result = await server.session.call("probe.point", asked);
      if (!isCurrent()) return undefined;
      model.probe.value = result.hit ? { result, time: model.readout.peek().time } : null;
      return result.position;
    } catch (error) {
      if (isCurrent()) this.deps.unanswered(error, "The values at the point cannot be read");
      return undefined;
    }
  }

  close(): void {
    this.deps.model.probe.value = null;
  }

  async copy(): Promise<void> {
    const description = this.deps.model.description.peek();
    const probe = this.deps.model.probe.peek();
    if (probe === null || description === null) return;
    const isCopied = await copyText(
      probeText(probe.result, {
        dataset: description.name,
        time: probe.time,
        lengthUnits: description.length_units,
        unitsOf: (name) => unitsOf(description, name),
      }),
    );
    if (isCopied) this.deps.tell("The values are in the clipboard");
    else this.deps.tell("The clipboard is blocked; allow the page to use it in the browser's settings", "error");
  }
}
