// A server, a browser and its pages: every suite needs the same, and so says only what is its own.
import { after, before } from "node:test";
import { launch, type Browser } from "./chromium.ts";
import { Client, type PageOptions } from "./page.ts";
import { datasets, Server } from "./server.ts";

export const data = datasets();
export const skip = data.length === 0 ? "no dataset: set CIEL_BROWSER_DATA" : false;

export class Stage {
  server!: Server;
  private browser!: Browser;
  private kept: Client | undefined;
  private readonly options: PageOptions;

  /** For the suite in which it is made; `options` are those of the page that its tests share. */
  constructor(options: PageOptions = {}) {
    this.options = options;
    before(async () => {
      this.server = await Server.started(data);
      this.browser = await launch();
    });
    after(async () => {
      await this.browser.close();
      await this.server.stop();
    });
  }

  /** A page of any server, whatever it shows. */
  open(address: string, options: PageOptions = {}): Promise<Client> {
    return Client.open(this.browser, address, options);
  }

  /** A page of its own, with a picture. */
  async fresh(options: PageOptions = {}, fragment = ""): Promise<Client> {
    await this.server.start(); // where a test before left it dead
    const client = await this.open(this.server.address + fragment, options);
    await client.settled();
    return client;
  }

  /** One page for all who leave it as it was. */
  async same(): Promise<Client> {
    await this.server.start();
    this.kept ??= await this.open(this.server.address, this.options);
    await this.kept.connected();
    await this.kept.settled();
    return this.kept;
  }
}
