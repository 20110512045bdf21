// Commands for the page: theme, panels, stream, canvases.
import { DEFAULTS } from "../generated/protocol";
import type { StreamChoice, Theme } from "../model/state";
import type { Box } from "../wasm/overlay";
import type { Size } from "../model/camera";
import type { Deps } from "./deps";
import type { Links } from "./links";
import { isDark, saveStream, saveTheme } from "./preferences";

export class PageCommands {
  constructor(
    private readonly deps: Deps,
    private readonly links: Links,
  ) {}

  setTheme(theme: Theme): void {
    saveTheme(theme);
    this.deps.model.theme.value = theme;
    this.matchBackground();
  }

  matchBackground(): void {
    const { model, server } = this.deps;
    const background = model.scene.peek()?.background ?? DEFAULTS.Scene.background;
    if (!background.startsWith("#")) server.editor.amend({ background: this.background() });
  }

  background(): "dark" | "light" {
    return isDark(this.deps.model.theme.peek()) ? "dark" : "light";
  }

  chooseStream(choice: StreamChoice): void {
    this.deps.model.streamChoice.value = choice;
    saveStream(choice);
    this.deps.server.streams.reconsider();
  }

  togglePanel(): void {
    const { panelOpen } = this.deps.model;
    panelOpen.value = !panelOpen.peek();
  }

  showHelp(open: boolean): void {
    this.deps.model.helpOpen.value = open;
  }

  async attach(images: HTMLCanvasElement, geometry: HTMLCanvasElement): Promise<void> {
    const attached = this.deps.view.attach(images, geometry);
    await this.links.start();
    await attached;
    this.deps.server.start();
  }

  resized(width: number, height: number, pixelRatio: number): void {
    this.deps.view.resized(width, height, pixelRatio);
  }

  /** The triad and the box axes avoid these boxes, which are in CSS pixels. */
  covered(taken: Box[]): void {
    this.deps.model.taken.value = taken;
  }

  legendsStand(corner: Size[]): void {
    this.deps.server.size.corner = corner;
  }

  pictureSize(times = 1): Size {
    return this.deps.server.size.pixels(times);
  }
}
