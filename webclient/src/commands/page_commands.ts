// Commands for the page: theme, panels, stream.
import type { StreamChoice, Theme } from "../model/state";
import type { Box } from "../model/overlay_room";
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

  /** Sets the scene's background to the theme, unless it is a custom color. */
  matchBackground(): void {
    const { editor } = this.deps.server;
    const background = editor.scene?.background ?? "dark";
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

  /** Call when the canvases exist. */
  async attach(images: HTMLCanvasElement, geometry: HTMLCanvasElement): Promise<void> {
    const attached = this.deps.view.attach(images, geometry);
    await this.links.start();
    await attached;
    this.deps.server.start();
  }

  /** Canvas size in CSS pixels. */
  resized(width: number, height: number, pixelRatio: number): void {
    this.deps.view.resized(width, height, pixelRatio);
  }

  /** Boxes of the overlays over the canvas, without the axes of the box. */
  covered(taken: Box[]): void {
    this.deps.model.taken.value = taken;
  }

  /** Rectangle of each legend, from the top right corner to its far end. */
  legendsStand(corner: Size[]): void {
    this.deps.server.size.corner = corner;
  }

  /** Size of a server-drawn picture: `times` the view's size, within the limit. */
  pictureSize(times = 1): Size {
    return this.deps.server.size.pixels(times);
  }
}
