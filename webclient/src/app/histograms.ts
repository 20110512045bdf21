// Histograms of the scalars in use, fetched once per dataset, scalar and step.
import type { Histogram } from "./state";

const KEPT = 200;

export class Histograms {
  private readonly known = new Map<string, Histogram | "asked" | "missing">();

  constructor(
    private readonly fetch: (dataset: string, array: string, time: number) => Promise<Histogram>,
    private readonly arrived: () => void,
  ) {}

  /** null until it has arrived, and where there is none. */
  get(dataset: string, array: string, time: number): Histogram | null {
    const key = JSON.stringify([dataset, array, time]);
    const found = this.known.get(key);
    if (found !== undefined) return typeof found === "string" ? null : found;
    this.remember(key, "asked");
    this.fetch(dataset, array, time).then(
      (histogram) => {
        this.remember(key, histogram);
        this.arrived();
      },
      () => this.remember(key, "missing"), // not written at this step: the layer itself says so
    );
    return null;
  }

  /** After a reconnection unanswered ones are asked again. */
  clear(): void {
    this.known.clear();
    this.arrived();
  }

  private remember(key: string, value: Histogram | "asked" | "missing"): void {
    this.known.delete(key);
    this.known.set(key, value);
    const oldest = this.known.keys().next().value;
    if (this.known.size > KEPT && oldest !== undefined) this.known.delete(oldest);
  }
}
