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

  /** Sets the scene's background to the background of the theme. Does not change a custom color. */
  matchBackground(): void {
    const { editor } = this.deps.server;
    const background = editor.scene?.background ?? DEFAULTS.Scene.background;
    if (!background.startsWith("#")) editor.amend({ background: this.background() });
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

  /** Starts drawing on the canvases, then connects to the server. Call when the canvases exist. */
  async attach(images: HTMLCanvasElement, geometry: HTMLCanvasElement): Promise<void> {
    const attached = this.deps.view.attach(images, geometry);
    await this.links.start();
    await attached;
    this.deps.server.start();
  }

  /** Call when the canvas has a new size, in CSS pixels. `pixelRatio`: device pixels per CSS pixel. */
  resized(width: number, height: number, pixelRatio: number): void {
    this.deps.view.resized(width, height, pixelRatio);
  }

  /**
   * Sets the boxes in CSS pixels that title, captions and legends cover. The triad and the box axes avoid these boxes.
   */
  covered(taken: Box[]): void {
    this.deps.model.taken.value = taken;
  }

  /**
   * Sets the space that the legends cover. For each legend, `corner` has the size of the rectangle from the canvas's
   * top right corner to the legend's lower left corner, in CSS pixels.
   */
  legendsStand(corner: Size[]): void {
    this.deps.server.size.corner = corner;
  }

  /** Returns the size in pixels of a picture `times` as large as the view, clamped to the limits of the contract. */
  pictureSize(times = 1): Size {
    return this.deps.server.size.pixels(times);
  }
}
