import { describe, expect, test } from "vitest";
import { CameraCommands } from "../src/commands/camera_commands";
import { ColorCommands } from "../src/commands/color_commands";
import type { Deps } from "../src/commands/deps";
import { ProbeCommands } from "../src/commands/probe_commands";
import type { Scene } from "../src/generated/protocol";
import { makeModel, update, type Model } from "../src/model/model";

const first: Scene = { dataset: "first" };
const second: Scene = { dataset: "second" };
const description = { name: "first", times: [0], arrays: [], bounds: [0, 1, 0, 1, 0, 1] };

/** `answer` ends the call that is under way. */
function stand(): { model: Model; deps: Deps; said: string[]; changes: unknown[]; answer: (result: unknown) => void } {
  const model = makeModel();
  update(model, { scene: first, description: description as never });
  const [said, changes]: [string[], unknown[]] = [[], []];
  let answer: (result: unknown) => void = () => undefined;
  const call = (): Promise<unknown> => new Promise((resolve) => (answer = resolve));
  const deps = {
    model,
    server: {
      tab: { id: "s" },
      session: { call },
      editor: { isConnected: true, change: (patch: unknown) => void changes.push(patch) },
      size: {
        aspect: 1,
        css: { width: 100, height: 100 },
        pixels: () => ({ width: 100, height: 100 }),
        clearOfCorner: (camera: unknown) => camera,
      },
      fail: (error: Error) => void said.push(error.message),
    },
    view: {},
    tell: (text: string) => void said.push(text),
    unanswered: (_: unknown, text: string) => void said.push(text),
  };
  const answerNow = (result: unknown): void => {
    answer(result);
  };
  return { model, deps: deps as unknown as Deps, said, changes, answer: answerNow };
}

describe("an answer about a dataset that is no longer shown", () => {
  test("is no probe", async () => {
    const { model, deps, said, answer } = stand();
    const asked = new ProbeCommands(deps).at(10, 10);
    update(model, { scene: second, probe: null });
    answer({ hit: true, position: [1, 2, 3], values: {} });
    expect(await asked).toBeUndefined();
    expect(model.probe.value).toBeNull();
    expect(said).toEqual([]);
  });

  test("is no range", async () => {
    const { model, deps, said, answer } = stand();
    const commands = new ColorCommands(deps);
    const inView = commands.rangeInView({ layers: ["iso"] });
    update(model, { scene: second });
    answer({ range: [1, 2] });
    expect(await inView).toBeNull();
    expect(said).toEqual([]);
  });

  test("moves no camera", async () => {
    const { model, deps, changes, answer } = stand();
    new CameraCommands(deps, () => Promise.resolve(null)).reset();
    update(model, { scene: second });
    answer({ bounds: [0, 9, 0, 9, 0, 9] });
    await new Promise((done) => setTimeout(done, 0));
    expect(changes).toEqual([]);
  });

  test("of the same dataset counts, although the scene has changed", async () => {
    const { model, deps, answer } = stand();
    const asked = new ProbeCommands(deps).at(10, 10);
    update(model, { scene: { ...first, time: 1 } });
    answer({ hit: true, position: [1, 2, 3], values: {} });
    expect(await asked).toEqual([1, 2, 3]);
    expect(model.probe.value).not.toBeNull();
  });
});
