import { describe, expect, test } from "vitest";
import { ColorCommands } from "../src/commands/color_commands";
import type { Deps } from "../src/commands/deps";
import { makeModel } from "../src/model/model";

function recorded(): { commands: ColorCommands; changes: unknown[] } {
  const changes: unknown[] = [];
  const deps = {
    model: makeModel(),
    server: { editor: { change: (patch: unknown) => void changes.push(patch) } },
  };
  return { commands: new ColorCommands(deps as unknown as Deps), changes };
}

describe("the logarithmic scale", () => {
  const of = { layers: ["iso"] };
  const linear = { array: "p", range: [-1, 10] as [number, number], symmetric: true };

  test("gives back what it has changed when it is switched off", () => {
    const { commands, changes } = recorded();
    commands.setLog(of, linear, true);
    const color = (changes[0] as { layers: { iso: { color: { range: [number, number] } } } }).layers.iso.color;
    expect(color).toMatchObject({ log: true, symmetric: null });
    commands.setLog(of, { array: "p", log: true, range: color.range }, false);
    expect(changes[1]).toEqual({ layers: { iso: { color: { log: null, symmetric: true, range: [-1, 10] } } } });
  });

  test("gives back nothing of other layers, and nothing twice", () => {
    const { commands, changes } = recorded();
    commands.setLog(of, linear, true);
    commands.setLog({ layers: ["cut"] }, { array: "p", log: true }, false);
    expect(changes[1]).toEqual({ layers: { cut: { color: { log: null } } } });
    commands.setLog(of, { array: "p", log: true }, false);
    commands.setLog(of, { array: "p", log: true }, false);
    expect(changes[3]).toEqual({ layers: { iso: { color: { log: null } } } });
  });
});
