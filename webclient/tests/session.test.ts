import { beforeEach, describe, expect, test } from "vitest";
import { PROTOCOL, type Scene } from "../src/generated/protocol";
import { makeModel, type Model } from "../src/model/model";
import { RpcError } from "../src/server/rpc";
import { SceneEditor } from "../src/server/editor";
import { Session, wordsFor, type StreamWish } from "../src/server/session";
import { FakeClock, FakeNetwork, settled } from "./fake_socket";
import { state } from "./session_state";

const scene: Scene = { dataset: "d", layers: { iso: { type: "iso", array: "p", values: [0] } } };

let network = new FakeNetwork();
let frames: (() => void)[] = [];
let views: number[] = [];
let failures: string[] = [];
let refusals: string[] = [];
let size = { width: 800, height: 600, pixel_ratio: 1 };
let wish: StreamWish = { stream: "image", moving: "jpeg" };
let clock = new FakeClock();
let model: Model;
let editor: SceneEditor;
let session: Session;

const join = async (held: Scene, view: number): Promise<void> => {
  network.newest.onopen?.();
  await settled();
  await network.newest.answer(state(held), "session.open");
  await network.newest.answer({ view }, "view.open");
};
const opened = (): Scene[] =>
  network.newest.calls("session.open").map(({ params }) => (params as { scene: Scene }).scene);
const gone = { code: -32001, message: "There is no dataset", data: {} };
const tooNew = {
  code: -32600,
  message: "Invalid Request",
  data: { reason: "the request is of protocol version 1.1; this server has version 2.0; use a client of version 2" },
};
/** Answers the question for the server's limit. The page asks it if it has steps to send. */
const told = async (messageBytes = 1 << 20): Promise<void> => {
  await settled();
  const [asked] = network.newest.calls("server.info");
  const result = { limits: { message_bytes: messageBytes } };
  network.newest.onmessage?.({ data: JSON.stringify({ jsonrpc: "2.0", id: asked?.id, result }) });
  await settled();
};
const reconnect = async (messageBytes?: number): Promise<void> => {
  network.newest.onclose?.();
  clock.advance(500);
  network.newest.onopen?.();
  await told(messageBytes);
};

beforeEach(() => {
  [network, clock, size] = [new FakeNetwork(), new FakeClock(), { width: 800, height: 600, pixel_ratio: 1 }];
  [frames, views, failures, refusals] = [[], [], [], []];
  wish = { stream: "image", moving: "jpeg" };
  model = makeModel();
  editor = new SceneEditor(
    model,
    {
      changed: () => undefined,
      accepted: () => undefined,
      refused: (error) => void failures.push(error.message),
      gone: () => undefined,
      stuck: () => undefined,
    },
    { now: () => clock.now(), requestFrame: (callback) => void frames.push(callback) },
    "g",
  );
  const host = {
    firstScene: () => Promise.resolve(scene),
    viewSize: () => size,
    stream: () => wish,
    viewOpening: () => void views.push(-1),
    viewOpened: (view: number) => void views.push(view),
    opened: () => undefined,
    refused: (error: Error) => void refusals.push(wordsFor(error)),
    connection: () => undefined,
    roundTrip: () => undefined,
    binary: () => undefined,
    notified: () => undefined,
    failed: (error: Error) => void failures.push(error.message),
  };
  const noPost = (): Promise<string> => Promise.reject(new Error("nothing goes by POST here"));
  session = new Session("s", host, editor, network.open, noPost, clock);
  session.start();
});

describe("session", () => {
  test("opens with the first scene, then a view of the canvas's size", async () => {
    await join(scene, 4);
    expect(network.newest.calls("session.open")).toMatchObject([{ params: { session: "s", scene } }]);
    expect(network.newest.calls("view.open")).toMatchObject([
      { params: { session: "s", width: 800, height: 600, stream: "image", moving: "jpeg" } },
    ]);
    expect(views.at(-1)).toBe(4);
    expect(editor.scene).toEqual(scene);
  });

  test("a canvas that changed while the view was opened is told", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    size = { width: 640, height: 480, pixel_ratio: 2 };
    session.resize(); // no effect: the view is not open yet
    await network.newest.answer({ view: 4 }, "view.open");
    expect(network.newest.calls("view.resize")).toMatchObject([
      { params: { view: 4, width: 640, height: 480, pixel_ratio: 2 } },
    ]);
    session.resize();
    expect(network.newest.calls("view.resize").length).toBe(1); // not sent again: the size is the same
  });

  test("a stream that was chosen while the view was opened is told", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    wish = { stream: "geometry", moving: "jpeg" };
    session.setStream(wish); // no effect: the view is not open yet
    await network.newest.answer({ view: 4 }, "view.open");
    expect(network.newest.calls("view.stream")).toMatchObject([{ params: { view: 4, stream: "geometry" } }]);
    session.setStream({ ...wish });
    expect(network.newest.calls("view.stream").length).toBe(1); // not sent again: the stream is the same
  });

  test("a server that was upgraded to another major version says so", async () => {
    await join(scene, 4);
    await reconnect();
    expect(network.newest.calls("session.open").at(-1)).toHaveProperty("protocol", PROTOCOL);
    await network.newest.refuse(tooNew, "session.open");
    expect(refusals).toEqual([
      "The request is of protocol version 1.1; this server has version 2.0; use a client of version 2",
    ]);
  });

  test("after a break the scene goes back as the hand left it", async () => {
    await join(scene, 4);
    network.newest.onclose?.();
    expect(views.at(-1)).toBe(0);
    editor.change({ layers: { iso: { values: [5] } } });
    clock.advance(500);
    expect(network.sockets.length).toBe(2);
    network.newest.onopen?.();
    await told();
    const reopened = network.newest.calls("session.open").at(-1)?.params as { scene: Scene };
    expect(reopened.scene.layers?.iso).toMatchObject({ values: [5] }); // for a server that lost the session
    await network.newest.answer(state(scene), "session.open"); // this server still has the old scene
    await network.newest.answer({ view: 9 }, "view.open");
    frames.splice(0).forEach((frame) => frame());
    expect(network.newest.calls("scene.patch")).toMatchObject([
      { params: { patch: { layers: { iso: { values: [5] } } } } },
    ]);
    expect(views.at(-1)).toBe(9);
  });

  test("after a break the steps that can be undone go along", async () => {
    await join(scene, 4);
    editor.change({ time: 1 });
    frames.splice(0).forEach((frame) => frame());
    await network.newest.answer({ revision: 2, can_undo: true, can_redo: false }, "scene.patch");
    editor.change({ time: 2 });
    frames.splice(0).forEach((frame) => frame());
    await network.newest.answer({ revision: 3, can_undo: true, can_redo: false }, "scene.patch");
    const undone = editor.undo();
    await settled();
    await network.newest.answer({ ...state({ ...scene, time: 1 }, 4), can_undo: true, can_redo: true }, "scene.undo");
    await undone;
    await reconnect();
    expect(network.newest.calls("session.open").at(-1)?.params).toEqual({
      session: "s",
      scene: { ...scene, time: 1 },
      undo: [{ time: null }],
      redo: [{ time: 2 }],
    });
    await network.newest.answer({ ...state({ ...scene, time: 1 }), can_undo: true, can_redo: true }, "session.open");
    expect([model.canUndo.value, model.canRedo.value]).toEqual([true, true]);
  });

  test("frames of a view that is gone are not acknowledged", async () => {
    await join(scene, 4);
    session.acknowledge(3, 1);
    expect(network.newest.calls("view.ack")).toEqual([]);
    session.acknowledge(4, 1);
    expect(network.newest.calls("view.ack")).toMatchObject([{ params: { view: 4, frame: 1 } }]);
  });

  test("a refused scene is said, a broken line is not", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.refuse({ code: -32002, message: "Invalid scene", data: {} }, "session.open");
    expect(refusals).toEqual(["Invalid scene"]);
    network.newest.onclose?.();
    await expect(session.call("dataset.list", {})).rejects.toThrow("connection ended");
    await settled();
    expect(refusals.length).toBe(1);
    expect(failures).toEqual([]);
  });

  test("frames are expected from the call that opens the view, not from its answer", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    expect(views.at(-1)).toBe(-1);
    await network.newest.answer({ view: 4 }, "view.open");
    expect(views.at(-1)).toBe(4);
  });

  test("what is chosen when the scene was refused opens the session at once, without what the hand did before", async () => {
    await join(scene, 4);
    editor.change({ layers: { iso: { values: [5] } } });
    await reconnect();
    await network.newest.refuse(gone, "session.open");
    expect(refusals).toEqual(["There is no dataset"]);
    expect([views.at(-1), editor.isConnected]).toEqual([0, false]);
    expect(editor.scene?.dataset).toBe("d"); // kept, since the dataset may come back
    editor.change({ layers: { iso: { values: [6] } } });
    const other: Scene = { dataset: "other" };
    const begun = session.begin(other);
    await settled();
    expect(opened().at(-1)).toEqual(other);
    await network.newest.answer(state(other), "session.open");
    await network.newest.answer({ view: 9 }, "view.open");
    await begun;
    frames.splice(0).forEach((frame) => frame());
    expect(editor.scene).toEqual(other);
    expect(views.at(-1)).toBe(9);
    expect([network.newest.calls("scene.patch"), editor.isPending]).toEqual([[], false]);
    await reconnect();
    expect(opened()).toEqual([other]);
  });

  test("a choice that is refused as well leaves the scene that was kept to try again", async () => {
    await join(scene, 4);
    await reconnect();
    await network.newest.refuse(gone, "session.open");
    void session.begin({ dataset: "other" });
    await settled();
    await network.newest.refuse(gone, "session.open");
    expect(refusals.length).toBe(2);
    void session.open();
    void session.open();
    await settled();
    expect(opened().map(({ dataset }) => dataset)).toEqual(["d", "other", "d"]);
    await network.newest.answer(state(scene), "session.open");
    await network.newest.answer({ view: 9 }, "view.open");
    expect(views.at(-1)).toBe(9);
    void session.open(); // no effect: the session is open
    await settled();
    expect(opened().length).toBe(3);
  });

  test("of two choices in a hurry the newest is shown", async () => {
    await join(scene, 4);
    await reconnect();
    await network.newest.refuse(gone, "session.open");
    void session.begin({ dataset: "first" });
    void session.begin({ dataset: "second" });
    await settled();
    expect(opened().at(-1)).toEqual({ dataset: "second" });
    void session.begin({ dataset: "third" });
    await network.newest.answer(state({ dataset: "second" }), "session.open");
    await network.newest.answer({ view: 9 }, "view.open");
    expect(network.newest.calls("scene.patch")).toMatchObject([{ params: { patch: { dataset: "third" } } }]);
    expect(network.newest.calls("view.open").length).toBe(1);
  });

  test("a session that another page has opened meanwhile is led to what was chosen", async () => {
    await join(scene, 4);
    await reconnect();
    await network.newest.refuse(gone, "session.open");
    void session.begin({ dataset: "mine" });
    await settled();
    await network.newest.answer(state({ dataset: "theirs" }), "session.open");
    expect(network.newest.calls("scene.patch")).toMatchObject([{ params: { patch: { dataset: "mine" } } }]);
  });

  test("a choice that the broken line has swallowed opens the session when it is back", async () => {
    await join(scene, 4);
    await reconnect();
    await network.newest.refuse(gone, "session.open");
    void session.begin({ dataset: "other" });
    await settled();
    await reconnect();
    expect(opened()).toEqual([{ dataset: "other" }]);
  });

  test("the steps that open a session again fit into a message to the server", async () => {
    await join(scene, 4);
    for (let time = 1; time <= 30; time += 1) {
      editor.change({ annotations: { title: String(time).repeat(400) } }, String(time));
      for (const draw of frames.splice(0)) draw();
      await network.newest.answer(state(editor.scene as Scene), "scene.patch");
    }
    await reconnect(6000);
    const [open] = network.newest.calls("session.open");
    expect((open?.params as { undo: unknown[] }).undo.length).toBeGreaterThan(0);
    expect(JSON.stringify(open).length).toBeLessThan(6000);
  });

  test("a view that is refused leaves no session that looks open", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    await network.newest.refuse({ code: -32003, message: "Too many views", data: {} }, "view.open");
    expect(refusals).toEqual(["Too many views"]);
    expect([views.at(-1), editor.isConnected]).toEqual([0, false]);
  });

  test("a person is told the reason and the place, which is named once", () => {
    const error = (data: unknown): string => wordsFor(new RpcError(-32002, "Invalid scene", data));
    expect(error({ reason: "must be a number", path: "/time" })).toBe("Must be a number (/time)");
    const named = { reason: "/layers/b/value must be a number", path: "/layers/b/value" };
    expect(error(named)).toBe("/layers/b/value must be a number");
    expect(error({ path: "" })).toBe("Invalid scene");
    expect(error(null)).toBe("Invalid scene");
    expect(wordsFor(new Error("plain"))).toBe("plain");
    const defect = new RpcError(-32603, "Internal error", { reason: "it broke", request: "3f2a9c01-17" });
    expect(wordsFor(defect)).toBe("It broke (request 3f2a9c01-17)");
  });
});
