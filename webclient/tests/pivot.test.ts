// Turns wait until the server has told the center of the orbit, but not for long.
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { CameraCommands } from "../src/commands/camera_commands";
import type { Deps } from "../src/commands/deps";
import type { ViewCamera } from "../src/model/camera";
import type { Scene, Vec3 } from "../src/generated/protocol";
import { makeModel } from "../src/model/model";
import { SceneEditor } from "../src/server/editor";
import type { Server } from "../src/server/server";
import { Pivot, PIVOT_PATIENCE_MS } from "../src/view/pivot";
import { state } from "./session_state";

type Picked = { position: Vec3 | null; center: Vec3 | null };
/** A scene.patch or scene.undo that the page sends. */
type Sent = { camera?: ViewCamera; layers?: object; gesture: string };

const scene = {
  dataset: "bar",
  camera: { position: [0, -6, 0], target: [0, 60, 0], up: [0, 0, 1], fov: 30 },
} as unknown as Scene;

function page(isConnected = true): {
  commands: CameraCommands;
  editor: SceneEditor;
  moves: Sent[];
  choose: (dataset: string) => void;
  answer: (picked: Picked) => Promise<void>;
  refuse: () => Promise<void>;
} {
  const moves: Sent[] = [];
  const calls: { resolve: (picked: Picked) => void; reject: (error: Error) => void }[] = [];
  const model = makeModel();
  const nothing = (): void => undefined;
  const events = { changed: nothing, accepted: nothing, refused: nothing, gone: nothing, stuck: nothing };
  const editor = new SceneEditor(model, events, { now: () => 0, requestFrame: (callback) => callback() }, "g");
  const answered = { revision: 2, can_undo: true, can_redo: false };
  editor.connected(
    {
      patch: (patch, gesture) => {
        moves.push({ ...patch, gesture });
        return Promise.resolve(answered);
      },
      undo: () => {
        moves.push({ gesture: "undo" });
        return Promise.resolve(state(scene));
      },
      redo: () => Promise.resolve(state(scene)),
      get: () => Promise.resolve(state(scene)),
    },
    state(scene),
  );
  if (!isConnected) editor.disconnected();
  const pick = (): Promise<Picked> => new Promise((resolve, reject) => calls.push({ resolve, reject }));
  const server = {
    model,
    editor,
    session: { call: pick },
    size: { css: { width: 600, height: 600 }, pixels: () => ({ width: 600, height: 600 }) },
    tab: { id: "a" },
  } as unknown as Server;
  const deps = { model, server, view: { pivot: new Pivot(server) } } as unknown as Deps;
  const newest = (): (typeof calls)[number] => calls.at(-1) ?? { resolve: vi.fn(), reject: vi.fn() };
  return {
    commands: new CameraCommands(deps, () => Promise.resolve(null)),
    editor,
    moves,
    choose: (dataset) => {
      model.scene.value = { ...scene, dataset };
    },
    answer: async (picked) => {
      newest().resolve(picked);
      await Promise.resolve();
    },
    refuse: async () => {
      newest().reject(new Error("no"));
      await Promise.resolve();
      await Promise.resolve();
    },
  };
}

const distance = (a: readonly number[], b: readonly number[]): number =>
  Math.hypot(...a.map((value, i) => value - (b[i] ?? 0)));

describe("a turn", () => {
  beforeEach(() => vi.useFakeTimers());
  afterEach(() => vi.useRealTimers());

  test("waits for the center and is then made whole, about it", async () => {
    const { commands, moves, answer } = page();
    commands.turnsAbout(300, 300);
    commands.turn(20, 0, "g");
    commands.turn(30, 5, "g");
    expect(moves).toEqual([]);
    await answer({ position: [0, 0, 0], center: null });
    expect(moves).toHaveLength(1);
    expect(moves[0]?.gesture).toBe("g");
    expect(distance(moves[0]?.camera?.position ?? [], [0, 0, 0])).toBeCloseTo(6);
    commands.turn(10, 0, "g");
    expect(moves).toHaveLength(2);
    expect(distance(moves[1]?.camera?.position ?? [], [0, 0, 0])).toBeCloseTo(6);
    vi.advanceTimersByTime(10 * PIVOT_PATIENCE_MS);
    expect(moves).toHaveLength(2);
  });

  test("is about the target if the answer is late, and about the center after it", async () => {
    const { commands, moves, answer } = page();
    commands.turnsAbout(300, 300);
    commands.turn(20, 0, "g");
    vi.advanceTimersByTime(PIVOT_PATIENCE_MS - 1);
    expect(moves).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(distance(moves[0]?.camera?.position ?? [], [0, 60, 0])).toBeCloseTo(66);
    const before = moves[0]?.camera?.position ?? [];
    await answer({ position: null, center: [1, 2, 3] });
    expect(moves).toHaveLength(1);
    commands.turn(20, 0, "g");
    expect(distance(moves[1]?.camera?.position ?? [], [1, 2, 3])).toBeCloseTo(distance(before, [1, 2, 3]));
  });

  test("is about the target at once if the server refuses, or is away", async () => {
    const { commands, moves, refuse } = page();
    commands.turnsAbout(300, 300);
    commands.turn(20, 0, "g");
    await refuse();
    expect(distance(moves[0]?.camera?.position ?? [], [0, 60, 0])).toBeCloseTo(66);
    const away = page(false);
    away.commands.turnsAbout(300, 300);
    away.commands.turn(20, 0, "g");
    const turned = away.commands.get()?.position ?? [];
    expect(distance(turned, [0, 60, 0])).toBeCloseTo(66);
    expect(distance(turned, [0, -6, 0])).toBeGreaterThan(1);
  });

  test("that waits is dropped when another dataset is chosen", async () => {
    const { commands, moves, choose, answer } = page();
    commands.turnsAbout(300, 300);
    commands.turn(20, 0, "g");
    choose("foo");
    await answer({ position: [0, 0, 0], center: null });
    expect(moves).toEqual([]);
    commands.turn(20, 0, "h");
    expect(moves.map(({ gesture }) => gesture)).toEqual(["h"]);
  });

  test("that waits comes before what the user does after it, and its center counts for the rest of the drag", async () => {
    const { commands, editor, moves, answer } = page();
    commands.turnBy(20, 0, "arrows", true);
    commands.zoomBy(0.5);
    expect(moves.map(({ gesture }) => gesture)).toEqual(["arrows", "g-1"]);
    expect(distance(moves[0]?.camera?.position ?? [], [0, 60, 0])).toBeCloseTo(66); // about the target
    expect(distance(moves[1]?.camera?.position ?? [], [0, 60, 0])).toBeCloseTo(33);
    await answer({ position: [0, 0, 0], center: null });
    expect(moves).toHaveLength(2);
    const before = moves[1]?.camera?.position ?? [];
    commands.turn(20, 0, "g");
    expect(distance(moves[2]?.camera?.position ?? [], [0, 0, 0])).toBeCloseTo(distance(before, [0, 0, 0]));
    await Promise.resolve();
    commands.turnBy(20, 0, "arrows", true);
    editor.change({ layers: { a: { opacity: 0.5 } } }, "layer");
    await Promise.resolve();
    commands.turnBy(0, 20, "arrows", true);
    void editor.undo();
    expect(moves.map(({ gesture }) => gesture).slice(3)).toEqual(["arrows", "layer", "arrows", "undo"]);
    await answer({ position: [0, 0, 0], center: null });
    expect(moves).toHaveLength(7);
  });

  test("waits on while time steps are played", async () => {
    const { commands, editor, moves, answer } = page();
    commands.turnBy(20, 0, "arrows", true);
    editor.changeAutomatically({ time: 2 }, "play");
    expect(moves.map(({ gesture }) => gesture)).toEqual(["play"]);
    await answer({ position: [0, 0, 0], center: null });
    expect(moves.map(({ gesture }) => gesture)).toEqual(["play", "arrows"]);
    expect(distance(moves[1]?.camera?.position ?? [], [0, 0, 0])).toBeCloseTo(6);
  });

  test("by a key waits too; an older answer does not count", async () => {
    const { commands, moves, answer } = page();
    commands.turnBy(20, 0, "a", true);
    expect(moves).toEqual([]);
    await answer({ position: [0, 0, 0], center: null });
    expect(moves).toHaveLength(1);
    commands.turnBy(20, 0, "a", false);
    expect(moves).toHaveLength(2);
    commands.turnsAbout(1, 1);
    commands.turnsAbout(2, 2);
    commands.turn(20, 0, "b");
    await answer({ position: [0, 0, 0], center: null });
    expect(moves.map(({ gesture }) => gesture)).toEqual(["a", "a", "b"]);
  });
});
