// Commands that export pictures, surfaces and links.
import { download } from "./download";
import type { Deps } from "./deps";
import type { Links } from "./links";

export type ExportFormat = "ply" | "stl" | "vtp";

export class FileCommands {
  constructor(
    private readonly deps: Deps,
    private readonly links: Links,
  ) {}

  /** Downloads a picture. `size`: in pixels; default: size of the view. */
  async screenshot(size = this.deps.server.size.pixels()): Promise<void> {
    const { server } = this.deps;
    await this.whileBusy("Drawing the picture", "The picture cannot be saved", async () => {
      const picture = await server.session.call("picture.render", { session: server.tab.id, ...size });
      download(`${server.editor.scene?.dataset ?? "ciel"}.png`, picture.mime, picture.data);
    });
  }

  async exportSurface(layer: string, format: ExportFormat, triangles: boolean): Promise<void> {
    const { server } = this.deps;
    await this.whileBusy("Writing the surface", "The surface cannot be exported", async () => {
      const file = await server.session.call("surface.export", { session: server.tab.id, layer, format, triangles });
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
      history.replaceState(null, "", address); // the clipboard needs a secure origin
      this.deps.tell(`The link to this ${what} is in the address bar`);
    }
  }

  /** Shows `words` as status during `work`. `failed`: start of the message if the connection is lost. */
  private async whileBusy(words: string, failed: string, work: () => Promise<void>): Promise<void> {
    const { busy } = this.deps.model;
    busy.value = words;
    try {
      await work();
    } catch (error) {
      this.deps.unanswered(error, failed);
    } finally {
      busy.value = null;
    }
  }
}
