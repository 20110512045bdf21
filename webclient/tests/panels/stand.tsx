// Renders one panel for tests, with a model but without a server. Commands are only recorded.
import { render, type JSX } from "preact";
import { act } from "preact/test-utils";
import { vi } from "vitest";
import { Commands } from "../../src/commands/commands";
import type { ArrayInfo, DatasetDescription, Scene } from "../../src/generated/protocol";
import { makeModel, type Model } from "../../src/model/model";
import type { PageState } from "../../src/model/state";
import { PageContext } from "../../src/panels/context";

type Call = [name: string, ...args: unknown[]];
type Answers = Record<string, unknown>;

const array = (name: string, range: [number, number], units: string): ArrayInfo => ({
  name,
  association: "point",
  components: 1,
  units,
  description: "",
  range,
  scalars: [name],
  times: [0, 0.5, 1],
  origin: "original",
  stored: "float32",
  invalid: 0,
  missing: 0,
});

export const described: DatasetDescription = {
  name: "box",
  source: "box.vtu",
  created: "",
  length_units: "m",
  times: [0, 0.5, 1],
  bounds: [0, 1, 0, 1, 0, 1],
  default_bounds: [0, 1, 0, 1, 0, 1],
  input: { vertices: 8, edges: 0, cells: 1 },
  mesh: {
    vertices: 8,
    edges: 12,
    half_edges: 24,
    faces: 6,
    cells: { hexahedron: 1 },
    boundary_faces: 6,
    components: 1,
  },
  arrays: [array("p", [0, 10], "Pa"), array("T", [200, 400], "K")],
  groups: [
    { name: "wall_left", of: "faces", count: 1 },
    { name: "wall_right", of: "faces", count: 1 },
    { name: "inlet", of: "faces", count: 4 },
  ],
  notes: [],
  default_scene: { dataset: "box", layers: {} },
};

const NONE = null as never;

const ANSWERS: Answers = {
  "layers.middleOf": 5,
  "layers.add": "iso2",
  newGesture: "gesture-1",
  histogram: null,
  "page.pictureSize": { width: 800, height: 600 },
  "camera.get": null,
};

/** Commands that only read. Panels call some of them at each rendering, so these calls are not recorded. */
const READS = new Set(["layers.middleOf", "newGesture", "histogram", "page.pictureSize", "camera.get"]);

/** Commands that cannot act, because they have no server, view and links. They tell which names there are. */
const realCommands = (model: Model): Commands => new Commands(model, NONE, NONE, NONE);

/**
 * A fake of all commands. Each call is recorded with the command's path. `answers` overrides the default results. Throws
 * for a name that `real` does not have.
 */
function recorder(real: object, calls: Call[], answers: Answers, path: readonly string[] = []): unknown {
  return new Proxy(real, {
    get: (_, member) => {
      if (typeof member !== "string") return undefined;
      const names = [...path, member];
      const name = names.join(".");
      const value: unknown = Reflect.get(real, member);
      if (typeof value === "object" && value !== null) return recorder(value, calls, answers, names);
      if (typeof value !== "function") throw new Error(`Commands has no ${name}; see src/commands/commands.ts`);
      return (...args: unknown[]) => {
        if (!READS.has(name)) calls.push([name, ...args]);
        return answers[name];
      };
    },
  });
}

/** Throws for an answer to a command that does not exist. */
function checkNames(commands: Commands, answers: Answers): void {
  for (const name of Object.keys(answers))
    name.split(".").reduce((part: unknown, member) => (part as Record<string, unknown>)[member], commands);
}

export function recordedCommands(model: Model, calls: Call[], answers: Answers = {}): Commands {
  Object.assign(answers, { ...ANSWERS, ...answers });
  const commands = recorder(realCommands(model), calls, answers) as Commands;
  checkNames(commands, answers);
  return commands;
}

/** A place on a track in percent of its size, from its upper left corner. */
type Place = readonly [x: number, y: number];

export interface Stand {
  model: Model;
  calls: Call[];
  root: HTMLElement;
  /** Returns the element with this accessible name, from its label or its text. */
  find: (name: string) => HTMLElement;
  click: (name: string) => void;
  key: (name: string, key: string) => void;
  /** Types into a number field or another field that takes the text at once, and presses Enter. */
  type: (name: string, text: string) => void;
  /** Chooses an option, a color or a text of a field that tells its value when it is complete. */
  choose: (name: string, value: string) => void;
  /** Moves a slider to each of the values, as one gesture. */
  slide: (name: string, ...values: number[]) => void;
  /** Presses the pointer on an element, moves it to each of the places, and releases it. */
  drag: (name: string, ...places: Place[]) => void;
  change: (change: () => void) => void;
  /** Lets a command have another result from now on. */
  answer: (name: string, result: unknown) => void;
}

const nameOf = (element: Element): string =>
  element.getAttribute("aria-label") ??
  element.closest("label")?.textContent.trim() ??
  (element.textContent.trim() || (element.getAttribute("title") ?? ""));

const NAMED = "button, input, select, [role=slider], [role=group], .points-bar, summary";

function finderIn(root: HTMLElement): (name: string) => HTMLElement {
  return (name) => {
    const all = [...root.querySelectorAll<HTMLElement>(NAMED)];
    const found = all.find((element) => nameOf(element) === name) ?? all.find((one) => nameOf(one).startsWith(name));
    if (found === undefined) throw new Error(`no ${name}; there are: ${all.map(nameOf).join(", ")}`);
    return found;
  };
}

/** Gives each element of the page a box of 100 by 100 pixels, because the fake page has no layout. */
function laidOut(work: () => void): void {
  const box = vi.spyOn(Element.prototype, "getBoundingClientRect").mockReturnValue(new DOMRect(0, 0, 100, 100));
  try {
    work();
  } finally {
    box.mockRestore();
  }
}

function dragged(element: HTMLElement, places: readonly Place[]): void {
  const events = [...places.map((place, i) => [i === 0 ? "pointerdown" : "pointermove", place] as const)];
  const [x, y] = places.at(-1) ?? [0, 0];
  laidOut(() => {
    for (const [type, [clientX, clientY]] of [...events, ["pointerup", [x, y]] as const]) {
      const event = new PointerEvent(type, { clientX, clientY, button: 0, pointerId: 1, bubbles: true });
      void act(() => void element.dispatchEvent(event));
    }
  });
}

function valued(element: HTMLElement, value: string, event: "input" | "change"): void {
  void act(() => {
    (element as HTMLInputElement).value = value;
    element.dispatchEvent(new Event(event, { bubbles: true }));
  });
}

export function stand(panel: JSX.Element, scene: Scene, state: Partial<PageState> = {}, answers: Answers = {}): Stand {
  const calls: Call[] = [];
  const model = makeModel({ scene, description: described, connection: { kind: "open" }, ...state });
  const root = document.createElement("div");
  document.body.replaceChildren(root);
  const changing = { ...answers };
  const commands = recordedCommands(model, calls, changing);
  void act(() => render(<PageContext.Provider value={{ model, commands }}>{panel}</PageContext.Provider>, root));
  const find = finderIn(root);
  const key = (name: string, pressed: string): void => {
    const event = new KeyboardEvent("keydown", { key: pressed, bubbles: true, cancelable: true });
    void act(() => void find(name).dispatchEvent(event));
  };
  return {
    model,
    calls,
    root,
    find,
    click: (name) => void act(() => find(name).click()),
    key,
    type: (name, text) => {
      valued(find(name), text, "input");
      key(name, "Enter");
    },
    choose: (name, value) => valued(find(name), value, "change"),
    slide: (name, ...values) => {
      const slider = find(name);
      void act(() => void slider.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true })));
      for (const value of values) valued(slider, String(value), "input");
    },
    drag: (name, ...places) => dragged(find(name), places),
    change: (change) => void act(change),
    answer: (name, result) => void Object.assign(changing, { [name]: result }),
  };
}
