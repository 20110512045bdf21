// All commands of the user, called by panels, keys and buttons. Each group of commands has its own file.
import { openingScene } from "../server/first_scene";
import { Disconnected } from "../server/rpc";
import type { Server } from "../server/server";
import { update, type Model } from "../model/model";
import type { Histogram } from "../model/state";
import { dismissToast, showToast } from "../model/toasts";
import { listenToGestures } from "../view/gestures";
import type { View } from "../view/view";
import { CameraCommands } from "./camera_commands";
import { ColorCommands } from "./color_commands";
import type { Deps } from "./deps";
import { FileCommands } from "./file_commands";
import { LayerCommands } from "./layer_commands";
import type { Links } from "./links";
import { PageCommands } from "./page_commands";
import { ProbeCommands } from "./probe_commands";
import { TimeCommands } from "./time_commands";

export class Commands {
  readonly camera: CameraCommands;
  readonly layers: LayerCommands;
  readonly colors: ColorCommands;
  readonly time: TimeCommands;
  readonly probe: ProbeCommands;
  readonly files: FileCommands;
  readonly page: PageCommands;

  constructor(
    private readonly model: Model,
    private readonly server: Server,
    view: View,
    links: Links,
  ) {
    const deps: Deps = {
      model,
      server,
      view,
      tell: (text, kind) => this.tell(text, kind),
      unanswered: (error, failed) => this.unanswered(error, failed),
    };
    this.probe = new ProbeCommands(deps);
    this.camera = new CameraCommands(deps, (x, y) => this.probe.at(x, y));
    this.layers = new LayerCommands(deps);
    this.colors = new ColorCommands(deps);
    this.time = new TimeCommands(deps);
    this.files = new FileCommands(deps, links);
    this.page = new PageCommands(deps, links);
  }

  listenTo(element: HTMLElement): void {
    const { camera, probe } = this;
    listenToGestures(element, {
      camera: () => camera.toMove(),
      size: () => this.server.size.css,
      zoomed: (now, factor, x, y) => camera.zoomed(now, factor, x, y),
      move: (next, gesture) => camera.set(next, gesture),
      newGesture: () => this.newGesture(),
      turnsAbout: (x, y) => camera.turnsAbout(x, y),
      turn: (dx, dy, gesture) => camera.turn(dx, dy, gesture),
      click: (x, y) => void probe.at(x, y),
      doubleClick: (x, y) => void camera.centerOn(x, y),
    });
  }

  /** Applies a merge patch to the scene. Changes with the same gesture name are one undo step. */
  change(patch: object, gesture?: string): void {
    this.server.editor.change(patch, gesture);
  }

  newGesture(): string {
    return this.server.editor.newGesture();
  }

  undo(): void {
    this.time.stop();
    void this.server.editor.undo();
  }

  redo(): void {
    this.time.stop();
    void this.server.editor.redo();
  }

  async openDataset(name: string): Promise<void> {
    const { model, server } = this;
    this.time.stop();
    model.chosen.value = name;
    try {
      const upcoming = await server.session.call("dataset.describe", { dataset: name });
      if (model.chosen.peek() !== name) return; // the user has chosen another dataset meanwhile
      update(model, { upcoming });
      const scene = openingScene(upcoming, server.size, this.page.background());
      if (server.editor.isConnected) server.editor.replace(scene);
      else await server.session.begin(scene);
    } catch (error) {
      this.unanswered(error, `${name} cannot be opened`);
    } finally {
      if (model.chosen.peek() === name) model.chosen.value = null;
    }
  }

  /** Returns null until the histogram has arrived, and if the array has no values at this time. */
  histogram(dataset: string, array: string, time: number): Histogram | null {
    return this.server.histograms.get(dataset, array, time);
  }

  retry(): void {
    this.server.session.retryNow();
  }

  async reopen(): Promise<void> {
    await this.server.session.open();
  }

  enterToken(typed: string): Promise<string | null> {
    return this.server.entry.enter(typed);
  }

  tell(text: string, kind: "error" | "info" = "info"): void {
    showToast(this.model, text, kind);
  }

  dismiss(toast: number): void {
    dismissToast(this.model, toast);
  }

  private unanswered(error: unknown, failed: string): void {
    if (error instanceof Disconnected)
      this.tell(`${failed}: the server is not connected. Try again when the connection is back`, "error");
    else this.server.fail(error);
  }
}
