// Stage: a server, a browser and pages for a test suite.
import { after, before } from "node:test";
import { launch, type Browser } from "./chromium.ts";
import { fragmentOf } from "./link.ts";
import { Client, type PageOptions } from "./page.ts";
import { datasets, nameOf, Server, type ServerOptions } from "./server.ts";

export const data = datasets();
export const skip = data.length === 0 ? "no dataset: set CIEL_BROWSER_DATA" : false;

interface Described {
  arrays: { association: string; scalars: string[]; components: number; range?: [number, number] }[];
  times: number[];
  default_scene: { layers: { surface?: { groups: string[] } } };
}

/** Fragment of an address with the scene that most suites use: an iso-surface at the first time step. */
export async function isoFragment(server: Server): Promise<string> {
  const dataset = nameOf(data[0] ?? "");
  const call = { jsonrpc: "2.0", id: 1, method: "dataset.describe", params: { dataset } };
  const answer = await fetch(`${server.address}rpc`, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(call),
  });
  const { arrays, times, default_scene: first } = ((await answer.json()) as { result: Described }).result;
  const ofPoints = arrays.filter(({ association }) => association === "point");
  const array = ofPoints.find(({ components }) => components === 1);
  const vector = ofPoints.find(({ components }) => components === 3);
  if (array?.range === undefined) return "";
  const [low, high] = array.range;
  const color = vector === undefined ? {} : { array: vector.scalars.find((name) => name.endsWith(":magnitude")) };
  const iso = { type: "iso", order: 2, array: array.scalars[0], values: [(low + high) / 2], color };
  const surface = first.layers.surface && { type: "surface", order: 1, groups: first.layers.surface.groups };
  return fragmentOf({ dataset, time: times[0], layers: { outline: { type: "outline", order: 0 }, surface, iso } });
}

interface StageOptions extends ServerOptions {
  /** Serves the datasets of CIEL_BROWSER_LARGE, which have the same names, for tests that need more or slower data. */
  large?: boolean;
}

export class Stage {
  server!: Server;
  private browser!: Browser;
  private kept: Client | undefined;
  private readonly options: PageOptions;

  /**
   * Starts the server and the browser before the surrounding suite, and ends them after it. `options`: for the page
   * that same() returns. Each suite has its own browser, because several run at once and clients of one browser see and
   * change each other's pages.
   */
  constructor(options: PageOptions = {}, { large = false, ...server }: StageOptions = {}) {
    this.options = options;
    before(async () => {
      const wanted = large ? datasets("CIEL_BROWSER_LARGE") : [];
      this.server = await Server.started(wanted.length > 0 ? wanted : data, server);
      this.browser = await launch();
    });
    after(async () => {
      await this.browser.close();
      await this.server.stop();
    });
  }

  /** Opens a page of any server, without waiting for a picture. */
  open(address: string, options: PageOptions = {}): Promise<Client> {
    return Client.open(this.browser, address, options);
  }

  /** Opens a new page and waits for its picture: of an iso-surface, or of the fragment's scene. */
  async fresh(options: PageOptions = {}, fragment?: string): Promise<Client> {
    await this.server.start(); // a previous test may have stopped the server
    const client = await this.open(this.server.address + (fragment ?? (await isoFragment(this.server))), options);
    await client.settled();
    return client;
  }

  /** Returns the page that tests of the suite share. Each test must leave its scene unchanged. */
  async same(): Promise<Client> {
    await this.server.start();
    this.kept ??= await this.open(this.server.address + (await isoFragment(this.server)), this.options);
    await this.kept.connected();
    await this.kept.settled();
    return this.kept;
  }
}
