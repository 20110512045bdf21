// Commands that export pictures, surfaces and links.
import { download } from "./download";
import type { Deps } from "./deps";
import type { Links } from "./links";

export type ExportFormat = "ply" | "stl" | "vtp";

export class FileCommands {
  private calls = 0;
  private canceller: AbortController | null = null;

  constructor(
    private readonly deps: Deps,
    private readonly links: Links,
  ) {}

  async screenshot(size = this.deps.server.size.pixels()): Promise<void> {
    const { model, server } = this.deps;
    await this.whileBusy("Drawing the picture", "The picture cannot be saved", async (progress, signal) => {
      const call = { session: server.tab.id, progress, ...size };
      const picture = await server.session.call("picture.render", call, signal);
      download(`${model.scene.peek()?.dataset ?? "ciel"}.png`, picture.mime, picture.data);
    });
  }

  async exportSurface(layer: string, format: ExportFormat, triangles: boolean): Promise<void> {
    const { server } = this.deps;
    await this.whileBusy("Writing the surface", "The surface cannot be exported", async (progress, signal) => {
      const call = { session: server.tab.id, progress, layer, format, triangles };
      const file = await server.session.call("surface.export", call, signal);
      download(file.name, file.mime, file.data);
      const origin = file.origin.some((c) => c !== 0) ? `; relative to the origin ${file.origin.join(" ")}` : "";
      this.deps.tell(`${file.name}: ${file.polygons} polygons, ${file.vertices} vertices${origin}`);
    });
  }

  async copyLink(): Promise<void> {
    await this.copyAddress(await this.links.address(), "view");
  }

  async copySessionLink(): Promise<void> {
    await this.copyAddress(this.links.sessionAddress(), "session");
  }

  private async copyAddress(address: string, what: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(address);
      this.deps.tell(`The link to this ${what} is in the clipboard`);
    } catch {
      history.replaceState(null, "", address); // browsers allow writeText() only on secure origins
      this.deps.tell(`The link to this ${what} is in the address bar`);
    }
  }

  cancel(): void {
    this.canceller?.abort();
  }

  /** `failed` is the start of the message if the connection is lost. */
  private async whileBusy(
    words: string,
    failed: string,
    work: (progress: string, signal: AbortSignal) => Promise<void>,
  ): Promise<void> {
    const { longCall } = this.deps.model;
    // Other pages of the session also receive this progress. The random number makes the name unique.
    const name = `${++this.calls} ${Math.random()}`;
    const canceller = new AbortController();
    this.canceller = canceller;
    longCall.value = { words, name, progress: null };
    try {
      await work(name, canceller.signal);
    } catch (error) {
      if (!canceller.signal.aborted) this.deps.unanswered(error, failed);
    } finally {
      if (longCall.peek()?.name === name) longCall.value = null;
    }
  }
}
