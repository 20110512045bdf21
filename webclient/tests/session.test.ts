import { beforeEach, describe, expect, test } from "vitest";
import type { Scene } from "../src/generated/protocol";
import { RpcError } from "../src/protocol/rpc";
import { SceneEditor } from "../src/scene/editor";
import { Session, wordsFor } from "../src/session/session";
import { FakeClock, FakeNetwork, settled } from "./fake_socket";
import { state } from "./session_state";

const scene: Scene = { dataset: "d", layers: { iso: { type: "iso", array: "p", values: [0] } } };

let network = new FakeNetwork();
let frames: (() => void)[] = [];
let views: number[] = [];
let failures: string[] = [];
let size = { width: 800, height: 600 };
let clock = new FakeClock();
let editor: SceneEditor;
let session: Session;

const join = async (held: Scene, view: number): Promise<void> => {
  network.newest.onopen?.();
  await settled();
  await network.newest.answer(state(held), "session.open");
  await network.newest.answer({ view }, "view.open");
};

beforeEach(() => {
  [network, clock, size] = [new FakeNetwork(), new FakeClock(), { width: 800, height: 600 }];
  [frames, views, failures] = [[], [], []];
  editor = new SceneEditor(
    { changed: () => undefined, accepted: () => undefined, refused: (error) => void failures.push(error.message) },
    { now: () => clock.now(), requestFrame: (callback) => void frames.push(callback) },
    "g",
  );
  const host = {
    firstScene: () => Promise.resolve(scene),
    viewSize: () => size,
    stream: () => "image" as const,
    viewOpening: () => void views.push(-1),
    viewOpened: (view: number) => void views.push(view),
    opened: () => undefined,
    connection: () => undefined,
    roundTrip: () => undefined,
    binary: () => undefined,
    notified: () => undefined,
    failed: (error: Error) => void failures.push(error.message),
  };
  session = new Session("s", host, editor, network.open, clock);
  session.start();
});

describe("session", () => {
  test("opens with the first scene, then a view of the canvas's size", async () => {
    await join(scene, 4);
    expect(network.newest.calls("session.open")).toMatchObject([{ params: { session: "s", scene } }]);
    expect(network.newest.calls("view.open")).toMatchObject([
      { params: { session: "s", width: 800, height: 600, stream: "image" } },
    ]);
    expect(views.at(-1)).toBe(4);
    expect(editor.scene).toEqual(scene);
  });

  test("a canvas that changed while the view was opened is told", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    size = { width: 640, height: 480 };
    session.resize(); // there is no view yet
    await network.newest.answer({ view: 4 }, "view.open");
    expect(network.newest.calls("view.resize")).toMatchObject([{ params: { view: 4, width: 640, height: 480 } }]);
    session.resize();
    expect(network.newest.calls("view.resize").length).toBe(1); // nothing new to tell
  });

  test("after a break the scene goes back as the hand left it", async () => {
    await join(scene, 4);
    network.newest.onclose?.();
    expect(views.at(-1)).toBe(0);
    editor.change({ layers: { iso: { values: [5] } } });
    clock.advance(500);
    expect(network.sockets.length).toBe(2);
    network.newest.onopen?.();
    await settled();
    const reopened = network.newest.calls("session.open").at(-1)?.params as { scene: Scene };
    expect(reopened.scene.layers?.iso).toMatchObject({ values: [5] }); // for a server that forgot the session
    await network.newest.answer(state(scene), "session.open"); // one that did not
    await network.newest.answer({ view: 9 }, "view.open");
    frames.splice(0).forEach((frame) => frame());
    expect(network.newest.calls("scene.patch")).toMatchObject([
      { params: { patch: { layers: { iso: { values: [5] } } } } },
    ]);
    expect(views.at(-1)).toBe(9);
  });

  test("frames of a view that is gone are not acknowledged", async () => {
    await join(scene, 4);
    session.acknowledge(3, 1);
    expect(network.newest.calls("view.ack")).toEqual([]);
    session.acknowledge(4, 1);
    expect(network.newest.calls("view.ack")).toMatchObject([{ params: { view: 4, frame: 1 } }]);
  });

  test("frames are expected from the call that opens the view, not from its answer", async () => {
    network.newest.onopen?.();
    await settled();
    await network.newest.answer(state(scene), "session.open");
    expect(views.at(-1)).toBe(-1);
    await network.newest.answer({ view: 4 }, "view.open");
    expect(views.at(-1)).toBe(4);
  });

  test("a refused scene is said, a broken line is not", async () => {
    network.newest.onopen?.();
    await settled();
    const error = { code: -32002, message: "Invalid scene", data: {} };
    network.newest.onmessage?.({
      data: JSON.stringify({ jsonrpc: "2.0", id: network.newest.calls("session.open")[0]?.id, error }),
    });
    await settled();
    expect(failures).toEqual(["Invalid scene"]);
    network.newest.onclose?.();
    await expect(session.call("dataset.list", {})).rejects.toThrow("connection ended");
    await settled();
    expect(failures.length).toBe(1);
  });

  test("a person is told the reason and the place", () => {
    const error = (data: unknown): string => wordsFor(new RpcError(-32002, "Invalid scene", data));
    expect(error({ reason: "must be a number", path: "/time" })).toBe("Must be a number (/time)");
    expect(error({ path: "" })).toBe("Invalid scene");
    expect(error(null)).toBe("Invalid scene");
    expect(wordsFor(new Error("plain"))).toBe("plain");
  });
});
