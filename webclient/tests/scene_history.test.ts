import { beforeEach, describe, expect, test } from "vitest";
import type { Scene } from "../src/generated/protocol";
import { applyPatch, type Json } from "../src/model/merge_patch";
import { SceneHistory } from "../src/server/scene_history";

const at = (time: number): Scene => ({ dataset: "d", time });
let history: SceneHistory;

/** Returns the scenes after each of the patches, as the server computes them. */
const scenes = (from: Scene, patches: object[]): Scene[] => {
  let scene = from as unknown as Json;
  return patches.map((patch) => (scene = applyPatch(scene, patch as Json)) as unknown as Scene);
};
const undone = (from: Scene): Scene[] => scenes(from, history.around(from).undo);
const redone = (from: Scene): Scene[] => scenes(from, history.around(from).redo);

beforeEach(() => {
  history = new SceneHistory();
  history.found(at(0));
});

describe("scene history", () => {
  test("each change is a step, the nearest first", () => {
    for (const time of [1, 2, 3]) history.changed({ time }, `g${String(time)}`);
    expect(undone(at(3))).toEqual([at(2), at(1), at(0)]);
    expect(redone(at(3))).toEqual([]);
  });

  test("changes of one gesture are one step", () => {
    history.changed({ time: 1 }, "first");
    for (const time of [2, 3, 4]) history.changed({ time }, "drag");
    expect(undone(at(4))).toEqual([at(1), at(0)]);
  });

  test("what was undone can be redone until something changes", () => {
    for (const time of [1, 2, 3]) history.changed({ time }, `g${String(time)}`);
    history.moved("undo", at(2));
    history.moved("undo", at(1));
    history.moved("redo", at(2));
    expect(undone(at(2))).toEqual([at(1), at(0)]);
    expect(redone(at(2))).toEqual([at(3)]);
    history.changed({ time: 7 }, "g3"); // a change after an undo starts a new gesture
    expect(undone(at(7))).toEqual([at(2), at(1), at(0)]);
    expect(redone(at(7))).toEqual([]);
  });

  test("an undo that has passed over a step has taken both", () => {
    for (const time of [1, 2, 3]) history.changed({ time }, `g${String(time)}`);
    history.moved("undo", at(1));
    expect(undone(at(1))).toEqual([at(0)]);
    expect(redone(at(1))).toEqual([at(2), at(3)]);
  });

  test("a reloaded page has the steps of the page before", () => {
    for (const time of [1, 2, 3]) history.changed({ time }, `g${String(time)}`);
    history.moved("undo", at(2));
    const text = history.asText();
    history = new SceneHistory();
    history.restore(text);
    expect(undone(at(2))).toEqual([at(1), at(0)]);
    expect(redone(at(2))).toEqual([at(3)]);
    history.found(at(2)); // the session has gone on without a change
    expect(undone(at(2))).toEqual([at(1), at(0)]);
    history.found(at(9));
    expect(undone(at(9))).toEqual([at(2), at(1), at(0)]);
  });

  test.each(["", "{", "null", "1", "{}", '{"scene":{"dataset":"d"},"undo":null,"redo":[]}'])(
    "%j is not taken for the steps of a page",
    (text) => {
      history.restore(text);
      expect(undone(at(0))).toEqual([]);
      expect(history.accepted).toEqual(at(0));
    },
  );

  test("a page without a session has no steps to store", () => {
    expect(new SceneHistory().asText()).toBe("");
  });

  test("changes of others in a row are one step", () => {
    history.changed({ time: 1 }, "mine");
    for (const time of [2, 3]) history.found(at(time));
    expect(undone(at(3))).toEqual([at(1), at(0)]);
  });

  test("after a new session has opened, the gesture before it does not go on", () => {
    history.changed({ time: 1 }, "g");
    history.endGesture();
    history.changed({ time: 2 }, "g");
    expect(undone(at(2))).toEqual([at(1), at(0)]);
  });

  test("changes that no server has taken are a step of their own", () => {
    history.changed({ time: 1 }, "g");
    expect(undone(at(5))).toEqual([at(1), at(0)]);
    expect(undone(at(1))).toEqual([at(0)]);
  });

  test("fifty steps are kept", () => {
    for (let time = 1; time <= 80; time += 1) history.changed({ time }, String(time));
    expect(undone(at(80)).length).toBe(50);
    expect(undone(at(80)).at(-1)).toEqual(at(30));
  });

  test.each([
    ["abcdefgh", 200_000],
    ["àáâãäåæç", 100_000], // two bytes each
  ])("of large steps as many are kept as one message holds with the scene: %s", (letters, count) => {
    const large = (letter: string): Scene => ({ ...at(0), annotations: { title: letter.repeat(count) } });
    for (const letter of letters) history.changed({ annotations: { title: letter.repeat(count) } }, letter);
    const [newest = "", ...older] = Array.from(letters).reverse();
    const message = JSON.stringify({ scene: large(newest), ...history.around(large(newest)) });
    expect(new TextEncoder().encode(message).length).toBeLessThan(1_001_000);
    expect(undone(large(newest))).toEqual(older.slice(0, 3).map(large));
  });

  test("as many steps are sent as one message to the server holds", () => {
    for (let time = 1; time <= 40; time += 1)
      history.changed({ annotations: { title: String(time).repeat(500) } }, String(time));
    const newest = history.accepted as Scene;
    const { undo } = history.around(newest, 8192);
    expect(undo.length).toBeGreaterThan(2);
    expect(JSON.stringify({ scene: newest, undo }).length).toBeLessThan(8192 - 1024);
    expect(history.around(newest).undo.length).toBe(40);
  });

  test("nothing is known of a session that was left", () => {
    history.changed({ time: 1 }, "g");
    history.forget();
    expect(history.around(at(1))).toEqual({ undo: [], redo: [] });
  });
});
