// What a person can do, as changes of the scene.
import { axisView, centre, complete, defaultView, withinReach, withParallel, zoom } from "../camera/camera";
import type { AxisView, Bounds, FullCamera } from "../camera/camera";
import type { Layer, Range, Vec3 } from "../generated/protocol";
import type { Json, JsonObject } from "../protocol/merge_patch";
import { Disconnected } from "../protocol/rpc";
import type { ColoringChange } from "../scene/color_edit";
import { movedTo } from "../scene/layer_order";
import { clamp } from "../scene/numbers";
import { coloredBy } from "../scene/new_looks";
import { patchesOf, withNone } from "../scene/patches";
import { percentiles } from "../scene/percentiles";
import { probeText } from "../scene/probe_text";
import { type Colored, arrayOf, freeId, nearestStep, shownTime, topOrder, unitsOf } from "../scene/scalars";
import type { App } from "./app";
import { copyText } from "./clipboard";
import { download } from "./download";
import { openingScene } from "./first_scene";
import { isDark, saveTheme } from "./preferences";
import type { Theme } from "./state";

export type ExportFormat = "ply" | "stl" | "vtp";

const USUAL_SHARES = [0.01, 0.99] as const;
const NOTHING_THERE =
  "Nothing is drawn there: a double click on a surface centres it. R shows all that is drawn, Shift-R the whole box";

export class Actions {
  constructor(private readonly app: App) {}

  /** The scene's camera; without one that which the server takes, or until it is known the default view. */
  camera(): FullCamera | null {
    const { scene } = this.app.editor;
    if (scene === null) return null;
    if (scene.camera) return complete(scene.camera);
    const bounds = this.bounds();
    return this.app.seenFrom.camera(scene) ?? (bounds === null ? null : defaultView(bounds, this.app.size.aspect));
  }

  setCamera(camera: FullCamera, gesture?: string): void {
    this.app.editor.change({ camera }, gesture);
  }

  /** About a place of the canvas in CSS pixels, to where a hand may come; the same camera if it is there already. */
  zoomed(camera: FullCamera, factor: number, x: number, y: number): FullCamera {
    const bounds = this.bounds();
    const allowed = bounds === null ? factor : withinReach(camera, factor, bounds);
    return allowed === 1 ? camera : zoom(camera, allowed, x, y, this.app.size.css);
  }

  /** Of what is drawn, or of the whole box. */
  resetView(wholeBox = false): void {
    void this.framed(wholeBox, (bounds, now) => defaultView(bounds, this.app.size.aspect, now.fov, now.parallel));
  }

  lookFrom(side: AxisView): void {
    void this.framed(false, (bounds, now) => axisView(side, bounds, this.app.size.aspect, now.fov, now.parallel));
  }

  private async framed(wholeBox: boolean, view: (bounds: Bounds, now: FullCamera) => FullCamera): Promise<void> {
    const { app } = this;
    let bounds = this.bounds();
    if (!wholeBox && app.editor.isConnected) {
      try {
        bounds = (await app.session.call("scene.bounds", { session: app.tab.id, of: "drawn" })).bounds;
      } catch (error) {
        app.fail(error);
      }
    }
    const now = this.camera();
    if (bounds !== null && now !== null) this.setCamera(app.size.clearOfCorner(view(bounds, now), bounds));
  }

  toggleParallel(): void {
    this.changeCamera((camera) => withParallel(camera, !camera.parallel));
  }

  changeCamera(change: (camera: FullCamera) => FullCamera, gesture?: string): void {
    const camera = this.camera();
    if (camera !== null) this.setCamera(change(camera), gesture);
  }

  /** The values under a canvas position in CSS pixels. Where nothing is drawn it is null, without an answer undefined. */
  async probe(x: number, y: number): Promise<Vec3 | null | undefined> {
    const { width, height } = this.app.size.pixels();
    const ratio = width / this.app.size.css.width;
    const session = this.app.tab.id;
    try {
      const result = await this.app.session.call("probe.point", {
        session,
        pixel: [x * ratio, y * ratio],
        width,
        height,
      });
      this.app.store.set({ probe: result.hit ? { result, time: this.app.store.get().readout.time } : null });
      return result.position;
    } catch (error) {
      this.unanswered(error, "The values there cannot be read");
      return undefined;
    }
  }

  async centreOn(x: number, y: number): Promise<void> {
    const point = await this.probe(x, y);
    const camera = this.camera();
    if (point === null) this.app.toasts.show(NOTHING_THERE);
    else if (point !== undefined && camera !== null) this.setCamera(centre(camera, point));
  }

  setLayer(id: string, change: object, gesture?: string): void {
    this.app.store.set({ touched: id });
    this.app.editor.change({ layers: { [id]: change } }, gesture);
  }

  async copyProbe(): Promise<void> {
    const { description, probe } = this.app.store.get();
    if (probe === null || description === null) return;
    const isCopied = await copyText(
      probeText(probe.result, {
        dataset: description.name,
        time: probe.time,
        lengthUnits: description.length_units,
        unitsOf: (name) => unitsOf(description, name),
      }),
    );
    if (isCopied) this.app.toasts.show("The values are in the clipboard");
    else this.app.toasts.show("This browser lets no page write to the clipboard", "error");
  }

  /** Of the whole boundary its other patches are left. */
  hidePatch(id: string, patch: string): void {
    const { description, scene } = this.app.store.get();
    const layer = scene?.layers?.[id];
    if (layer?.type !== "surface") return;
    const all = patchesOf(description);
    const left = withNone(
      all,
      layer.groups ?? [],
      all.filter(({ name }) => name === patch),
    );
    this.setLayer(id, left === null ? { visible: false } : { groups: left });
    this.app.store.set({ probe: null });
  }

  onlyPatch(id: string, patch: string): void {
    if (this.app.editor.scene?.layers?.[id]?.type === "surface") this.setLayer(id, { groups: [patch] });
  }

  removeLayer(id: string): void {
    this.app.editor.change({ layers: { [id]: null } });
  }

  /** To a place among all layers, which is counted without it. */
  moveLayer(id: string, place: number): void {
    const { scene } = this.app.editor;
    const layers = scene === null ? null : movedTo(scene, id, place);
    if (layers !== null) this.app.editor.change({ layers });
  }

  addLayer(prefix: string, layer: Layer): string | null {
    const { scene } = this.app.editor;
    if (scene === null) return null;
    const id = freeId(scene, prefix);
    this.app.store.set({ touched: id });
    this.app.editor.change({ layers: { [id]: { ...layer, order: topOrder(scene) } } });
    return id;
  }

  /** The middle of the array's range now, where an iso-surface begins. */
  middleOf(array: string): number {
    const { description, scene } = this.app.store.get();
    const time = shownTime(description, scene);
    const known = description === null ? null : this.app.histograms.get(description.name, array, time);
    const [low, high] = known?.range ?? arrayOf(description, array)?.range ?? [0, 1];
    return (low + high) / 2;
  }

  /** One colouring for several layers, as one step. undefined members are taken away. */
  setColoring({ layers, contours = [] }: Colored, change: ColoringChange, gesture?: string): void {
    const color: JsonObject = {};
    for (const [key, value] of Object.entries(change)) color[key] = (value ?? null) as unknown as Json;
    const patch: JsonObject = Object.fromEntries(layers.map((id) => [id, { color }]));
    this.app.store.set({ touched: layers.at(-1) ?? contours.at(-1) ?? null });
    for (const id of contours) patch[id] = { ...(patch[id] as JsonObject | undefined), contours: { coloring: color } };
    this.app.editor.change({ layers: patch }, gesture);
  }

  /** null: in one colour. What the scale was like belonged to the array before. */
  colorBy(of: Colored, array: string | null): void {
    const { description, scene } = this.app.store.get();
    if (array === null) this.setColoring(of, { array: undefined, range: undefined });
    else this.setColoring(of, { range: undefined, ...coloredBy(scene, description, array) });
  }

  /** Without the values that lie far away from all others; null where there is none, or no answer. */
  async usualRange(array: string): Promise<Range | null> {
    const { app } = this;
    const { description, scene } = app.store.get();
    if (description === null) return null;
    const asked = { dataset: description.name, array, time: shownTime(description, scene), bins: 1024 };
    try {
      return await percentiles(
        (range) => app.session.call("dataset.histogram", { ...asked, ...(range !== null && { range }) }),
        USUAL_SHARES,
      );
    } catch (error) {
      this.unanswered(error, "The range of most values cannot be told");
      return null;
    }
  }

  /** Of the values that are shown in the view; null where there is none, which is said. */
  async rangeInView(colored: Colored): Promise<Range | null> {
    const { app } = this;
    const of = async (part: keyof Colored): Promise<Range[]> => {
      const layers = colored[part] ?? [];
      if (layers.length === 0) return [];
      const asked = { session: app.tab.id, layers, aspect: app.size.aspect, of: part };
      const { range } = await app.session.call("color.range", asked);
      return range === null ? [] : [range];
    };
    try {
      const ranges = [...(await of("layers")), ...(await of("contours"))];
      if (ranges.length > 0)
        return [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))];
      app.toasts.show("No value of these layers is in view; the range stays as it is", "error");
      return null;
    } catch (error) {
      this.unanswered(error, "The range in view cannot be told");
      return null;
    }
  }

  setStep(step: number, gesture?: string): void {
    const times = this.app.store.get().description?.times ?? [];
    const time = times[clamp(step, 0, times.length - 1)];
    if (time !== undefined) this.app.editor.change({ time }, gesture);
  }

  stepBy(steps: number): void {
    const { description, scene } = this.app.store.get();
    const times = description?.times ?? [];
    this.app.player.stop();
    this.setStep(nearestStep(times, scene?.time) + steps);
  }

  togglePlay(): void {
    if (this.app.player.playing) this.app.player.stop();
    else this.app.player.play();
  }

  undo(): void {
    this.app.player.stop();
    void this.app.editor.undo();
  }

  redo(): void {
    this.app.player.stop();
    void this.app.editor.redo();
  }

  async openDataset(name: string): Promise<void> {
    const { app } = this;
    app.player.stop();
    app.store.set({ chosen: name });
    try {
      const upcoming = await app.session.call("dataset.describe", { dataset: name });
      if (app.store.get().chosen !== name) return; // another was chosen meanwhile
      app.store.set({ upcoming });
      const scene = openingScene(upcoming, app.size, this.themeBackground());
      if (app.editor.isConnected) app.editor.replace(scene);
      else await app.session.begin(scene);
    } catch (error) {
      this.unanswered(error, `${name} cannot be opened`);
    } finally {
      if (app.store.get().chosen === name) app.store.set({ chosen: null });
    }
  }

  /** As large as the view's, or as given. */
  async screenshot(size = this.app.size.pixels()): Promise<void> {
    const { app } = this;
    await this.whileBusy("Drawing the picture", "The picture cannot be saved", async () => {
      const picture = await app.session.call("picture.render", { session: app.tab.id, ...size });
      download(`${app.editor.scene?.dataset ?? "ciel"}.png`, picture.mime, picture.data);
    });
  }

  async exportSurface(layer: string, format: ExportFormat, triangles: boolean): Promise<void> {
    const { app } = this;
    await this.whileBusy("Writing the surface", "The surface cannot be exported", async () => {
      const file = await app.session.call("surface.export", { session: app.tab.id, layer, format, triangles });
      download(file.name, file.mime, file.data);
      const origin = file.origin.some((c) => c !== 0) ? `; relative to the origin ${file.origin.join(" ")}` : "";
      app.toasts.show(`${file.name}: ${file.polygons} polygons, ${file.vertices} vertices${origin}`);
    });
  }

  async copyLink(): Promise<void> {
    await this.copyAddress(await this.app.links.address(), "view");
  }

  async copySessionLink(): Promise<void> {
    await this.copyAddress(this.app.links.sessionAddress(), "session");
  }

  private async copyAddress(address: string, what: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(address);
      this.app.toasts.show(`The link to this ${what} is in the clipboard`);
    } catch {
      history.replaceState(null, "", address); // no clipboard without a secure origin
      this.app.toasts.show(`The link to this ${what} is in the address bar`);
    }
  }

  themeBackground(): "dark" | "light" {
    return isDark(this.app.store.get().theme) ? "dark" : "light";
  }

  setTheme(theme: Theme): void {
    saveTheme(theme);
    this.app.store.set({ theme });
    this.matchBackground();
  }

  /** To the theme, unless it is a colour of its own. */
  matchBackground(): void {
    const background = this.app.editor.scene?.background ?? "dark";
    if (!background.startsWith("#")) this.app.editor.amend({ background: this.themeBackground() });
  }

  /** `failed`: what has not been done if the connection is gone. */
  private async whileBusy(words: string, failed: string, work: () => Promise<void>): Promise<void> {
    this.app.store.set({ busy: words });
    try {
      await work();
    } catch (error) {
      this.unanswered(error, failed);
    } finally {
      this.app.store.set({ busy: null });
    }
  }

  /** What a hand asks of the server is not done later by itself, as changes of the scene are. */
  private unanswered(error: unknown, failed: string): void {
    if (error instanceof Disconnected)
      this.app.toasts.show(`${failed}: the server is not connected. Try again when it is back`, "error");
    else this.app.fail(error);
  }

  private bounds(): Bounds | null {
    return this.app.store.get().description?.bounds ?? null;
  }
}
