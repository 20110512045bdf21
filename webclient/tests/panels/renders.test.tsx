// @vitest-environment happy-dom
import { options, render, type ComponentType, type JSX, type VNode } from "preact";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, expect, test } from "vitest";
import type { Scene } from "../../src/generated/protocol";
import { makeModel, type Model } from "../../src/model/model";
import { emptyReadout } from "../../src/model/state";
import { PageContext } from "../../src/panels/context";
import { CameraSection } from "../../src/panels/look/camera_section";
import { Shell } from "../../src/panels/shell/shell";
import { TokenForm } from "../../src/panels/stage/token_form";
import { Ahead } from "../../src/panels/stage/ahead";
import { Annotations } from "../../src/panels/stage/annotations";
import { ProbeCard } from "../../src/panels/stage/probe_card";
import { SceneEditor } from "../../src/server/editor";
import { state } from "../session_state";
import { fullScene } from "./full_scene";
import { described, recordedCommands } from "./stand";

type Counts = Record<string, number>;
type Panel = (this: unknown, ...args: unknown[]) => unknown;

let counts: Counts = {};
const counting = new Map<unknown, Panel>();
const { vnode } = options as { vnode?: (node: VNode) => void };

/** Returns a component that counts the renderings of `panel`. The same for each element of it. */
function counted(panel: Panel): Panel {
  const known = counting.get(panel);
  if (known !== undefined) return known;
  const wrapper: Panel = function (...args) {
    counts[panel.name] = (counts[panel.name] ?? 0) + 1;
    return panel.apply(this, args);
  };
  counting.set(panel, wrapper);
  return wrapper;
}

const NO_PANELS = new Set(["Provider", "Fragment"]);

beforeEach(() => {
  options.vnode = (node) => {
    const { type } = node;
    if (typeof type === "function" && /^[A-Z]\w/.test(type.name) && !NO_PANELS.has(type.name))
      node.type = counted(type as Panel) as ComponentType;
    vnode?.(node);
  };
});
afterEach(() => {
  if (vnode === undefined) delete options.vnode;
  else options.vnode = vnode;
});

type Stream = "image" | "geometry";

const busy = (stream: Stream): typeof emptyReadout => ({ ...emptyReadout, stream, revision: 1, latencyMs: 500 });
const PROBE = {
  result: { hit: true, position: [0.5, 0.5, 0.5], vertex: 1, cell: 0, layer: "wall", patch: "inlet", values: { p: 1 } },
  time: 0,
};

/** Clicks all that unfolds, until nothing is left folded. */
function unfold(root: HTMLElement): void {
  const seen = new Set<Element>();
  for (;;) {
    const folded = [...root.querySelectorAll<HTMLElement>("[aria-expanded=false]")].filter((one) => !seen.has(one));
    if (folded.length === 0) return;
    for (const one of folded) {
      seen.add(one);
      void act(() => one.click());
    }
  }
}

/**
 * Mounts and unfolds a panel, with a scene of all layers, a probe and a late picture. Returns the number of renderings
 * by component: first all, then those of the camera's move.
 */
function rendered(panel: JSX.Element, stream: Stream): { atFirst: Counts; byMove: Counts } {
  const model = makeModel({
    scene: fullScene,
    description: described,
    connection: { kind: "open" },
    readout: busy(stream),
    revision: 2,
    shownScene: { ...fullScene, time: 1 },
    probe: PROBE as never,
    helpOpen: true,
  });
  const editor = dragging(model);
  const root = document.createElement("div");
  document.body.replaceChildren(root);
  const commands = recordedCommands(model, []);
  const mounted = <PageContext.Provider value={{ model, commands }}>{panel}</PageContext.Provider>;
  counts = {};
  void act(() => render(mounted, root));
  unfold(root);
  const atFirst = counts;
  counts = {};
  move(editor);
  const byMove = counts;
  void act(() => render(null, root));
  return { atFirst, byMove };
}

const cameraAt = (x: number): Scene["camera"] => ({ position: [x, -9, 0], target: [0, 0, 0], up: [0, 0, 1] });

/** Returns an editor of the model's scene that has sent nothing of a drag of the camera yet. */
function dragging(model: Model): SceneEditor {
  const nothing = (): void => undefined;
  const editor = new SceneEditor(
    model,
    { changed: nothing, accepted: nothing, refused: nothing, gone: nothing, stuck: nothing },
    { now: () => 0, requestFrame: nothing },
    "g",
  );
  const never = (): Promise<never> => new Promise(nothing);
  editor.connected({ patch: never, undo: never, redo: never, get: never }, state(fullScene));
  editor.change({ camera: cameraAt(0.5) }, "drag");
  return editor;
}

/** Moves the camera as the view does, then as another page of the session does. */
function move(editor: SceneEditor): void {
  void act(() => editor.change({ camera: cameraAt(1) }, "drag"));
  void act(() => editor.overheard({ ...structuredClone(fullScene), camera: cameraAt(2) }));
}

function sum(parts: Counts[]): Counts {
  const total: Counts = {};
  for (const part of parts) for (const [name, count] of Object.entries(part)) total[name] = (total[name] ?? 0) + count;
  return total;
}

/** Names of the components that the files of src/panels export. */
const modules: Record<string, object> = import.meta.glob("../../src/panels/**/*.tsx", { eager: true });
const exported = Object.values(modules).flatMap((module) =>
  Object.entries(module).flatMap(([name, value]) => (typeof value === "function" && /^[A-Z]/.test(name) ? [name] : [])),
);

// Over polygons, the axes and the mark of the probe follow the newest camera. Over pictures, they follow the picture.
test.each([
  { stream: "geometry" as const, byMove: [["Annotations", "Drawing", "Fills"], ["ProbeMark"], ["Drawn"]] },
  { stream: "image" as const, byMove: [[], [], ["Drawn"]] },
])("a camera that moves over $stream renders only the panels that show the camera", ({ stream, byMove }) => {
  const all = rendered(
    <>
      <Shell />
      <TokenForm />
    </>,
    stream,
  );
  expect(exported.filter((name) => all.atFirst[name] === undefined)).toEqual([]);
  const [camera = {}, ...others] = [<CameraSection />, <Annotations />, <ProbeCard />, <Ahead />].map(
    (panel) => rendered(panel, stream).byMove,
  );
  expect(Object.keys(camera)).not.toEqual([]);
  expect(others.map((part) => Object.keys(part))).toEqual(byMove);
  expect(all.byMove).toEqual(sum([camera, ...others]));
});
