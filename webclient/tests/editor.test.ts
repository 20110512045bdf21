import { effect } from "@preact/signals";
import { beforeEach, describe, expect, test } from "vitest";
import type { Layer, Revision, Scene } from "../src/generated/protocol";
import { makeModel, type Model } from "../src/model/model";
import { Disconnected, RpcError } from "../src/server/rpc";
import { SceneEditor } from "../src/server/editor";
import { settled } from "./fake_socket";
import { state } from "./session_state";

interface Sent {
  patch: object;
  gesture: string;
  answer: (revision: Revision) => void;
  refuse: (error: Error) => void;
}

const scene: Scene = {
  dataset: "d",
  layers: { iso: { type: "iso", array: "p", values: [0] }, outline: { type: "outline" } },
};
const taken = (revision: number): Revision => ({ revision, can_undo: true, can_redo: false });

let sent: Sent[] = [];
let wire: string[] = []; // methods called on the fake server, in order
let frames: (() => void)[] = [];
let refused: Error[] = [];
let gone: string[] = [];
let stuck: string[] = [];
let accepted: [revision: number, scene: Scene][] = [];
let model: Model;
let editor: SceneEditor;
let held = scene; // the fake server's scene
let canUndo = false;
let time = 0;
let lost: Error | null = null; // error with which the fake server refuses undo; null: accepts it

const server = {
  patch: (patch: object, gesture: string) => {
    wire.push("patch");
    return new Promise<Revision>((answer, refuse) => sent.push({ patch, gesture, answer, refuse }));
  },
  undo: () => {
    wire.push("undo");
    return lost === null ? Promise.resolve(state(structuredClone(scene), 9)) : Promise.reject(lost);
  },
  redo: () => {
    wire.push("redo");
    return Promise.resolve(state(scene, 10));
  },
  get: () => Promise.resolve({ ...state(held, 11), can_undo: canUndo }),
};
const runFrame = (): void => frames.splice(0).forEach((frame) => frame());
const values = (): number[] | undefined => {
  const layer = editor.scene?.layers?.iso;
  return layer?.type === "iso" ? layer.values : undefined;
};
const setValue = (value: number, gesture?: string): void =>
  editor.change({ layers: { iso: { values: [value] } } }, gesture);

/** Returns an editor as a newly loaded page has it. `name`: begins the names of its gestures. */
function loadPage(name: string): SceneEditor {
  const events = {
    changed: () => undefined,
    accepted: (revision: number, _: number, of: Scene) => void accepted.push([revision, of]),
    refused: (error: Error) => void refused.push(error),
    gone: (layer: Layer) => void gone.push(layer.type),
    stuck: (step: string, { message }: Error) => void stuck.push(`${step}: ${message}`),
  };
  const timing = { now: () => time, requestFrame: (callback: () => void) => void frames.push(callback) };
  model = makeModel();
  return new SceneEditor(model, events, timing, name);
}

beforeEach(() => {
  [sent, wire, frames, refused, gone, stuck, held, canUndo, lost] = [[], [], [], [], [], [], scene, false, null];
  [time, accepted] = [0, []];
  editor = loadPage("g");
  editor.connected(server, state(scene));
});

describe("scene editor", () => {
  test("a drag is seen at once and sent once a frame, as one gesture", () => {
    const gesture = editor.newGesture();
    for (const value of [1, 2, 3]) setValue(value, gesture);
    expect(values()).toEqual([3]);
    expect(sent.length).toBe(0);
    runFrame();
    expect(sent).toMatchObject([{ patch: { layers: { iso: { values: [3] } } }, gesture }]);
    setValue(4, gesture);
    runFrame();
    expect(sent.map((s) => s.gesture)).toEqual([gesture, gesture]);
  });

  test("each reader of the model runs once for a move of the hand, and once for the server's answer", async () => {
    const read: unknown[] = [];
    effect(() => {
      const iso = model.scene.value?.layers?.iso;
      read.push([iso?.type === "iso" && iso.values, model.pending.value, model.canUndo.value]);
    });
    setValue(1);
    runFrame();
    sent[0]?.answer(taken(2));
    await settled();
    expect(read).toEqual([
      [[0], false, false],
      [[1], true, false],
      [[1], false, true],
    ]);
  });

  test("different gestures are different patches", () => {
    setValue(1);
    editor.change({ background: "light" });
    runFrame();
    expect(sent.length).toBe(2);
    expect(sent[0]?.gesture).not.toBe(sent[1]?.gesture);
  });

  test("members that a change, an answer or another page leaves alone stay the same objects", async () => {
    const layersBefore = editor.scene?.layers;
    editor.change({ camera: { position: [0, 0, 9], target: [0, 0, 0] } });
    expect(editor.scene?.layers).toBe(layersBefore);
    held = { ...structuredClone(scene), background: "light" };
    editor.overheard(held);
    expect(editor.scene).toMatchObject({ background: "light", camera: { position: [0, 0, 9] } });
    expect(editor.scene?.layers).toBe(layersBefore);
    await editor.undo(); // the server answers with another copy of the whole scene
    expect(editor.scene?.background).toBeUndefined();
    expect(editor.scene?.layers).toBe(layersBefore);
  });

  test("an amendment is undone with the step before it", () => {
    setValue(1);
    editor.amend({ background: "light" });
    runFrame();
    expect(new Set(sent.map((s) => s.gesture)).size).toBe(1);
    expect(sent.at(-1)?.patch).toMatchObject({ background: "light" });
  });

  test("an amendment belongs to the step before it, however that was named", () => {
    setValue(1, "arrow-keys");
    editor.newGesture(); // a click that changed nothing
    editor.amend({ background: "light" });
    runFrame();
    expect(sent.map((s) => s.gesture)).toEqual(["arrow-keys"]);
  });

  test("an amendment after a reload is undone with the step before the reload", async () => {
    setValue(1);
    runFrame();
    sent[0]?.answer(taken(2));
    await settled();
    const text = editor.stepsAsText();
    const edited = editor.scene ?? scene;
    editor = loadPage("h");
    editor.restoreSteps(text);
    editor.connected(server, state(edited));
    editor.amend({ background: "light" });
    runFrame();
    expect(sent.at(-1)?.patch).toEqual({ background: "light" });
    expect(sent.at(-1)?.gesture).toBe(sent[0]?.gesture);
  });

  test("a slow server gets the newest, not everything", async () => {
    const gesture = editor.newGesture();
    for (let value = 1; value <= 50; value += 1) {
      setValue(value, gesture);
      runFrame();
    }
    expect(sent.length).toBe(2);
    sent[0]?.answer(taken(2));
    await settled();
    expect(sent.length).toBe(3);
    expect(sent[2]?.patch).toEqual({ layers: { iso: { values: [50] } } });
    expect(model.canUndo.value).toBe(true);
  });

  test("over a long line no change waits for the answer to another", async () => {
    const gesture = editor.newGesture();
    setValue(1, gesture);
    runFrame();
    time = 200;
    sent[0]?.answer(taken(2));
    await settled();
    for (let value = 2; value <= 13; value += 1) {
      setValue(value, gesture);
      runFrame();
    }
    expect(sent.length).toBe(13);
  });

  test("what changes nothing is not sent", () => {
    setValue(0);
    runFrame();
    expect(sent.length).toBe(0);
  });

  test("an undo first sends what the hand did last, then takes the server's word", async () => {
    setValue(7);
    await editor.undo();
    expect(wire).toEqual(["patch", "undo"]);
    expect(sent.map(({ patch }) => patch)).toEqual([{ layers: { iso: { values: [7] } } }]);
    expect(editor.scene).toEqual(scene);
  });

  test("an undo to what cannot be shown any more is said, and not offered until there is something else to undo", async () => {
    setValue(7);
    runFrame();
    sent[0]?.answer(taken(2));
    await settled();
    expect(model.canUndo.value).toBe(true);
    lost = new RpcError(-32001, "There is no dataset", {});
    await editor.undo();
    expect(stuck).toEqual(["undo: There is no dataset"]);
    expect(refused).toEqual([]);
    expect([model.canUndo.value, editor.isPending, values()]).toEqual([false, false, [7]]);
    setValue(8);
    runFrame();
    sent[1]?.answer(taken(3));
    await settled();
    expect(model.canUndo.value).toBe(true);
  });

  test("a refused change is taken back and said", async () => {
    setValue(7);
    runFrame();
    sent[0]?.refuse(new RpcError(-32002, "Invalid scene", { path: "/layers/iso/values/0" }));
    await settled();
    expect(refused.length).toBe(1);
    expect(values()).toEqual([0]);
  });

  test("another client's change arrives under what is not sent yet", () => {
    setValue(7);
    editor.overheard({ ...scene, background: "light" });
    expect(editor.scene?.background).toBe("light");
    expect(values()).toEqual([7]);
  });

  test("an accepted change is told with the server's scene, without what the server has not accepted", async () => {
    setValue(7);
    runFrame();
    editor.overheard({ ...scene, background: "light" });
    setValue(8);
    sent[0]?.answer(taken(3));
    await settled();
    const iso: Layer = { type: "iso", array: "p", values: [7] };
    expect(accepted).toEqual([[3, { ...scene, background: "light", layers: { ...scene.layers, iso } }]]);
  });

  test("another client's change does not undo one that is on its way", async () => {
    setValue(7);
    runFrame();
    editor.overheard({ ...scene, background: "light" });
    expect(values()).toEqual([7]);
    held = { ...scene, background: "light", layers: { iso: { type: "iso", array: "p", values: [8] } } };
    await settled();
    expect(values()).toEqual([7]); // the server's scene is not fetched before this change is answered
    sent[0]?.answer(taken(3));
    await settled();
    expect(values()).toEqual([8]); // the server's scene wins
  });

  test("what can be undone is asked for when another client has changed the scene", async () => {
    held = { ...scene, background: "light" };
    canUndo = true;
    editor.overheard(held);
    expect(model.canUndo.value).toBe(false);
    await settled();
    expect(model.canUndo.value).toBe(true);
    expect(editor.scene).toEqual(held);
  });

  test("an undo keeps what the hand did after it", async () => {
    const undone = editor.undo();
    expect(editor.isPending).toBe(true);
    setValue(7);
    await undone;
    expect(values()).toEqual([7]);
    runFrame();
    expect(sent.length).toBe(1);
  });

  test("a foreign scene stands when the server has taken it", async () => {
    held = { dataset: "other" };
    const proposed = editor.propose(held);
    expect(editor.scene).toEqual(scene);
    expect(sent).toMatchObject([{ patch: { dataset: "other", layers: null } }]);
    sent[0]?.answer(taken(2));
    expect(editor.isPending).toBe(true);
    await proposed;
    expect(editor.scene).toEqual(held);
    expect(editor.isPending).toBe(false);
  });

  test("a foreign scene that the server refuses changes nothing", async () => {
    const proposed = editor.propose({ dataset: "other", layers: { iso: {} } } as unknown as Scene);
    sent[0]?.refuse(new RpcError(-32002, "Invalid scene", {}));
    await proposed;
    expect(editor.scene).toEqual(scene);
    expect(editor.isPending).toBe(false);
    expect(refused.length).toBe(1);
    editor.disconnected();
    await editor.propose({ dataset: "other" });
    expect(refused.length).toBe(2);
    expect(editor.scene).toEqual(scene);
  });
});

describe("a layer that another client removes", () => {
  const without: Scene = { dataset: "d", layers: { outline: { type: "outline" } } };

  test("is not changed any more: that is said, and nothing is sent", () => {
    editor.overheard(without);
    setValue(5);
    editor.change({ background: "light", layers: { iso: { smooth: false }, outline: { visible: false } } });
    runFrame();
    expect(gone).toEqual(["iso", "iso"]);
    expect(sent.map(({ patch }) => patch)).toEqual([{ background: "light", layers: { outline: { visible: false } } }]);
    expect(editor.scene?.layers).toEqual({ outline: { type: "outline", visible: false } });
  });

  test("is no more for what is not sent yet, and what is on its way is refused without another word", async () => {
    setValue(5);
    runFrame();
    setValue(6);
    editor.overheard((held = without));
    expect(gone).toEqual(["iso", "iso"]);
    expect(editor.scene).toEqual(without);
    sent[0]?.refuse(new RpcError(-32002, "Invalid scene", {}));
    await settled();
    runFrame();
    expect([sent.length, refused.length, editor.isPending]).toEqual([1, 0, false]);
  });

  test("may be added again, and is changed then", () => {
    editor.overheard(without);
    editor.change({ layers: { iso: { type: "iso", array: "p", values: [1] } } });
    setValue(2);
    expect([gone, values()]).toEqual([[], [2]]);
  });
});

describe("without a connection", () => {
  test("there is no history: the server keeps it", async () => {
    setValue(7);
    runFrame();
    sent[0]?.answer(taken(2));
    await settled();
    editor.disconnected();
    expect(model.canUndo.value).toBe(false);
  });

  test("an undo is not lost without a word", async () => {
    editor.disconnected();
    await editor.undo();
    expect(refused.length).toBe(1);
    expect(editor.isPending).toBe(false);
  });

  test("an undo that the broken line has swallowed leaves nothing pending", async () => {
    const undone = editor.undo();
    editor.disconnected();
    await undone;
    expect(editor.isPending).toBe(false);
    editor.connected(server, state(scene, 20));
    expect(editor.isPending).toBe(false);
  });

  test("the hand goes on, and one patch brings the server up to date", () => {
    editor.disconnected();
    setValue(5);
    editor.change({ background: "light", layers: { outline: null } });
    runFrame();
    expect(sent.length).toBe(0);
    editor.connected(server, state(scene, 20));
    runFrame();
    expect(sent.length).toBe(1);
    expect(sent[0]?.patch).toEqual({ background: "light", layers: { iso: { values: [5] }, outline: null } });
    expect(values()).toEqual([5]);
  });

  test("a change that was on its way when the line broke is not lost", async () => {
    setValue(5);
    runFrame();
    sent[0]?.refuse(new Disconnected());
    await settled();
    editor.disconnected();
    expect(refused).toEqual([]);
    editor.connected(server, state(scene, 3)); // the server has not received the change that was in flight
    runFrame();
    expect(sent.at(-1)?.patch).toEqual({ layers: { iso: { values: [5] } } });
  });

  test("with nothing unsent the server's scene stands", () => {
    editor.disconnected();
    const other: Scene = { dataset: "other" };
    editor.connected(server, state(other, 4));
    expect(editor.scene).toEqual(other);
    runFrame();
    expect(sent.length).toBe(0);
  });
});
