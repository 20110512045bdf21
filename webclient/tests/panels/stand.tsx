// Renders one panel for tests, with a model but without a server. Commands are only recorded.
import { render, type JSX } from "preact";
import { act } from "preact/test-utils";
import type { Commands } from "../../src/commands/commands";
import type { DatasetDescription, Scene } from "../../src/generated/protocol";
import { makeModel, type Model } from "../../src/model/model";
import type { PageState } from "../../src/model/state";
import { PageContext } from "../../src/panels/context";

type Call = [name: string, ...args: unknown[]];

export const described = {
  name: "box",
  length_units: "m",
  times: [0, 0.5, 1],
  bounds: { min: [0, 0, 0], max: [1, 1, 1] },
  arrays: [
    { name: "p", association: "point", components: 1, range: [0, 10], units: "Pa", scalars: ["p"] },
    { name: "T", association: "point", components: 1, range: [200, 400], units: "K", scalars: ["T"] },
  ],
  groups: [],
  default_scene: { dataset: "box", layers: {} },
  mesh: { vertices: 8, cells: { hexahedron: 1 } },
} as unknown as DatasetDescription;

const ANSWERS: Record<string, unknown> = {
  "layers.middleOf": 5,
  "layers.add": "iso2",
  newGesture: "gesture-1",
  histogram: null,
  "page.pictureSize": { width: 800, height: 600 },
  "camera.get": null,
};

/** A fake of all commands. Each call is recorded with the command's path; some return a fixed result. */
function recorder(calls: Call[], path: string[] = []): unknown {
  return new Proxy(() => undefined, {
    get: (_, name) =>
      path.length === 0 && name === "colors" ? recordColors(calls) : recorder(calls, [...path, String(name)]),
    apply: (_, __, args: unknown[]) => {
      const name = path.join(".");
      if (!(name in ANSWERS) || name === "layers.add") calls.push([name, ...args]);
      return ANSWERS[name];
    },
  });
}

function recordColors(calls: Call[]): unknown {
  const beforeLog = new Map();
  return new Proxy(
    {},
    { get: (_, name) => (name === "beforeLog" ? beforeLog : recorder(calls, ["colors", String(name)])) },
  );
}

export interface Stand {
  model: Model;
  calls: Call[];
  root: HTMLElement;
  /** Returns the element with this accessible name, from its label or its text. */
  find: (name: string) => HTMLElement;
  click: (name: string) => void;
  key: (name: string, key: string) => void;
  type: (name: string, text: string) => void;
  change: (change: () => void) => void;
}

const nameOf = (element: Element): string =>
  element.getAttribute("aria-label") ??
  element.closest("label")?.textContent.trim() ??
  element.getAttribute("title") ??
  element.textContent.trim();

export function stand(panel: JSX.Element, scene: Scene, state: Partial<PageState> = {}): Stand {
  const calls: Call[] = [];
  const model = makeModel({ scene, description: described, connection: { kind: "open" }, ...state });
  const root = document.createElement("div");
  document.body.replaceChildren(root);
  const commands = recorder(calls) as Commands;
  void act(() => render(<PageContext.Provider value={{ model, commands }}>{panel}</PageContext.Provider>, root));
  const find = (name: string): HTMLElement => {
    const all = [...root.querySelectorAll<HTMLElement>("button, input, select, [role=slider], summary")];
    const found = all.find((element) => nameOf(element) === name) ?? all.find((one) => nameOf(one).startsWith(name));
    if (found === undefined) throw new Error(`no ${name}; there are: ${all.map(nameOf).join(", ")}`);
    return found;
  };
  const dispatch = (name: string, event: Event): void => void act(() => void find(name).dispatchEvent(event));
  return {
    model,
    calls,
    root,
    find,
    click: (name) => void act(() => find(name).click()),
    key: (name, key) => dispatch(name, new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })),
    type: (name, text) => {
      const field = find(name) as HTMLInputElement;
      void act(() => {
        field.value = text;
        field.dispatchEvent(new Event("input", { bubbles: true }));
      });
      dispatch(name, new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true }));
    },
    change: (change) => void act(change),
  };
}
