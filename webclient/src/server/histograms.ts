// Histograms of scalars, fetched once for each dataset, scalar and time step.
import { signal, type Signal } from "@preact/signals";
import { ErrorCode } from "../generated/protocol";
import { Disconnected, RpcError } from "./rpc";
import type { Histogram } from "../model/state";

const KEPT = 200;
/** The server computes few histograms at a time, and refuses further requests of a connection with too many. */
const AT_ONCE = 2;
const RETRY_MILLISECONDS = 1000;

interface Known {
  histogram: Signal<Histogram | null>;
  state: "forgotten" | "wanted" | "asked" | "missing" | "here";
}
type Of = [dataset: string, array: string, time: number];

export class Histograms {
  private readonly known = new Map<string, Known>();
  private wanted: Of[] = [];
  private underWay = 0;
  private isDue = false;
  /** Number of calls of clear(). An answer is ignored if clear() was called after the request. */
  private cleared = 0;

  constructor(
    private readonly fetch: (...of: Of) => Promise<Histogram>,
    private readonly later: (callback: () => void, milliseconds: number) => void,
  ) {}

  /**
   * Returns null until the histogram has arrived, and if the array has no values at this time. Code that reads signals
   * runs again when the histogram arrives.
   */
  get(...of: Of): Histogram | null {
    const known = this.knownOf(of);
    if (known.state === "forgotten") this.want(of, 0);
    return known.histogram.value;
  }

  clear(): void {
    for (const known of this.known.values()) {
      known.state = "forgotten";
      known.histogram.value = null;
    }
    this.wanted = [];
    this.underWay = 0;
    this.cleared += 1;
  }

  private want(of: Of, milliseconds: number): void {
    this.remember(of, "wanted");
    this.wanted.push(of);
    if (this.isDue) return;
    this.isDue = true;
    this.later(() => {
      this.isDue = false;
      this.askMore();
    }, milliseconds);
  }

  private askMore(): void {
    while (this.underWay < AT_ONCE) {
      const of = this.wanted.shift();
      if (of === undefined) return;
      void this.ask(of);
    }
  }

  private async ask(of: Of): Promise<void> {
    const { cleared } = this;
    this.underWay += 1;
    this.remember(of, "asked");
    const answer = await this.fetch(...of).catch((error: unknown) => error as Error);
    if (this.cleared !== cleared) return;
    this.underWay -= 1;
    if (!(answer instanceof Error)) {
      this.remember(of, "here", answer);
    } else if (answer instanceof RpcError && answer.code === ErrorCode.Limit) {
      this.want(of, RETRY_MILLISECONDS);
      return; // the server would refuse further requests too
    } else if (answer instanceof Disconnected) {
      this.remember(of, "forgotten");
    } else {
      this.remember(of, "missing"); // the array has no values at this step; the layer reports this
    }
    this.askMore();
  }

  private remember(of: Of, state: Known["state"], histogram: Histogram | null = null): void {
    const key = JSON.stringify(of);
    const known = this.knownOf(of);
    this.known.delete(key);
    // Moves the entry to the end of the map, so that the first entry of the map is the oldest.
    this.known.set(key, known);
    known.state = state;
    if (histogram !== null) known.histogram.value = histogram;
  }

  private knownOf(of: Of): Known {
    const key = JSON.stringify(of);
    const found = this.known.get(key);
    if (found !== undefined) return found;
    const made: Known = { histogram: signal(null), state: "forgotten" };
    this.known.set(key, made);
    const oldest = this.known.keys().next().value;
    if (this.known.size > KEPT && oldest !== undefined) this.known.delete(oldest);
    return made;
  }
}
