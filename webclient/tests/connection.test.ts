import { beforeEach, describe, expect, test } from "vitest";
import contract from "../../protocol/openrpc.json";
import { Connection, HEARTBEAT_MS, LAST_RETRY_MS, retryDelay } from "../src/server/connection";
import type { ConnectionState } from "../src/model/state";
import { Disconnected, Rpc, RpcError } from "../src/server/rpc";
import { FakeClock, FakeNetwork, settled } from "./fake_socket";

const noPost = (): Promise<string> => Promise.reject(new Error("nothing goes by POST here"));

describe("JSON-RPC", () => {
  test("answers find their calls, in any order; errors reject", async () => {
    const sent: string[] = [];
    const rpc = new Rpc(
      (text) => sent.push(text),
      () => undefined,
      noPost,
    );
    const first = rpc.call("dataset.list", {});
    const second = rpc.call("scene.get", { session: "a" });
    expect(JSON.parse(sent[1] ?? "")).toMatchObject({
      jsonrpc: "2.0",
      id: 2,
      method: "scene.get",
      params: { session: "a" },
    });
    const error = { code: -32001, message: "Not found", data: { reason: "no session a" } };
    rpc.receive(JSON.stringify({ jsonrpc: "2.0", id: 2, error }));
    rpc.receive(JSON.stringify({ jsonrpc: "2.0", id: 99, result: "to nobody" }));
    rpc.receive(JSON.stringify({ jsonrpc: "2.0", id: 1, result: [] }));
    expect(await first).toEqual([]);
    await expect(second).rejects.toEqual(new RpcError(-32001, "Not found", error.data));
  });

  test("what is unanswered ends with the connection", async () => {
    const rpc = new Rpc(
      () => undefined,
      () => undefined,
      noPost,
    );
    const call = rpc.call("dataset.list", {});
    rpc.close();
    await expect(call).rejects.toBeInstanceOf(Disconnected);
  });

  test("notifications have no id and are told by name", () => {
    const heard: unknown[] = [];
    const sent: string[] = [];
    const rpc = new Rpc(
      (text) => sent.push(text),
      (name, params) => heard.push([name, params]),
      noPost,
    );
    rpc.notify("view.ack", { view: 1, frame: 2 });
    expect(JSON.parse(sent[0] ?? "")).not.toHaveProperty("id");
    rpc.receive('{"jsonrpc":"2.0","method":"server.draining","params":{}}');
    expect(heard).toEqual([["server.draining", {}]]);
  });
});

describe("the version of the contract", () => {
  test("is declared by calls, notifications and what goes by POST", async () => {
    const sent: string[] = [];
    const send = (text: string): void => void sent.push(text);
    const post = (text: string): Promise<string> => {
      send(text);
      return Promise.resolve('{"result":{}}');
    };
    const rpc = new Rpc(send, () => undefined, post);
    void rpc.call("dataset.list", {});
    rpc.notify("view.ack", { view: 1, frame: 2 });
    await rpc.call("picture.render", {});
    const { info } = contract;
    for (const text of sent) {
      const { major, minor } = (JSON.parse(text) as { protocol: Record<"major" | "minor", number> }).protocol;
      expect(info.version).toMatch(`${major}.${minor}.`);
    }
    expect(sent.length).toBe(3);
  });
});

describe("long answers", () => {
  const begun = (answers: object[]): { rpc: Rpc; sent: string[]; posted: string[] } => {
    const [sent, posted]: [string[], string[]] = [[], []];
    const post = (text: string): Promise<string> => {
      posted.push(text);
      return Promise.resolve(JSON.stringify(answers.shift()));
    };
    return {
      rpc: new Rpc(
        (text) => sent.push(text),
        () => undefined,
        post,
      ),
      sent,
      posted,
    };
  };
  const tooLong = (id: number): string =>
    JSON.stringify({ jsonrpc: "2.0", id, error: { code: -32006, message: "long" } });
  const methods = (texts: string[]): string[] => texts.map((text) => (JSON.parse(text) as { method: string }).method);

  test("pictures and files of surfaces are asked for by POST", async () => {
    const picture = { mime: "image/png", data: "AA==" };
    const { rpc, sent, posted } = begun([{ result: picture }, { error: { code: -32001, message: "no layer" } }]);
    expect(await rpc.call("picture.render", { session: "s", width: 16, height: 16 })).toEqual(picture);
    await expect(rpc.call("surface.export", { session: "s", layer: "l", format: "ply" })).rejects.toThrow("no layer");
    expect(sent).toEqual([]);
    expect(JSON.parse(posted[0] ?? "")).toMatchObject({
      method: "picture.render",
      params: { session: "s", width: 16 },
    });
  });

  test("what is too long for the socket is asked for again by POST, and what was done is not done twice", async () => {
    const { rpc, sent, posted } = begun([{ result: { revision: 1 } }, { result: { revision: 2 } }]);
    const got = rpc.call("scene.get", { session: "s" });
    const undone = rpc.call("scene.undo", { session: "s" });
    rpc.receive(tooLong(1));
    rpc.receive(tooLong(2));
    expect([await got, await undone]).toEqual([{ revision: 1 }, { revision: 2 }]);
    expect(methods(sent)).toEqual(["scene.get", "scene.undo"]);
    expect(methods(posted)).toEqual(["scene.get", "scene.get"]);
  });
});

describe("reconnection", () => {
  let network = new FakeNetwork();
  let states: ConnectionState[] = [];
  let opened = 0;
  let rpc: Rpc | undefined;
  let clock = new FakeClock();
  let connection: Connection;

  beforeEach(() => {
    [network, states, opened, rpc, clock] = [new FakeNetwork(), [], 0, undefined, new FakeClock()];
    const events = {
      state: (state: ConnectionState) => void states.push(state),
      opened: (fresh: Rpc) => {
        opened += 1;
        rpc = fresh;
      },
      notification: () => undefined,
      binary: () => undefined,
      roundTrip: () => undefined,
    };
    connection = new Connection(network.open, noPost, events, clock);
    connection.start();
  });

  test("delays double up to a limit, and chance only shortens them", () => {
    expect([0, 1, 2, 3].map((attempt) => retryDelay(attempt, 1))).toEqual([500, 1000, 2000, 4000]);
    expect(retryDelay(50, 1)).toBe(LAST_RETRY_MS);
    expect(retryDelay(0, 0)).toBe(375);
  });

  test("a socket that closes is followed by another, later each time", () => {
    network.newest.onopen?.();
    expect(states.at(-1)).toEqual({ kind: "open" });
    for (const delay of [500, 1000, 2000]) {
      const before = network.sockets.length;
      network.newest.onclose?.();
      expect(states.at(-1)).toMatchObject({ kind: "waiting", retryAt: clock.now() + delay });
      clock.advance(delay - 1);
      expect(network.sockets.length).toBe(before);
      clock.advance(1);
      expect(network.sockets.length).toBe(before + 1);
    }
    network.newest.onopen?.();
    network.newest.onclose?.();
    expect(states.at(-1)).toMatchObject({ attempt: 0 }); // a successful connection resets the retry delay
    expect(opened).toBe(2);
  });

  test("a hand that says now does not wait", () => {
    network.newest.onclose?.();
    connection.retryNow();
    expect(network.sockets.length).toBe(2);
    connection.retryNow(); // does nothing: a socket is already being opened
    expect(network.sockets.length).toBe(2);
  });

  test("a socket that never opens is given up", () => {
    clock.advance(10_000);
    expect(network.newest.closed).toBe(true);
    expect(states.at(-1)?.kind).toBe("waiting");
  });

  test("a silent server is found out by the heartbeat, an answering one is kept", async () => {
    network.newest.onopen?.();
    await network.newest.answer({});
    clock.advance(HEARTBEAT_MS);
    expect(network.newest.sent.length).toBe(2);
    expect(states.at(-1)?.kind).toBe("open");
    clock.advance(HEARTBEAT_MS);
    expect(states.at(-1)?.kind).toBe("waiting");
  });

  test("an answer with an error is a sign of life, and the heartbeat goes on", async () => {
    network.newest.onopen?.();
    const error = { code: -32000, message: "busy" };
    network.newest.onmessage?.({ data: JSON.stringify({ jsonrpc: "2.0", id: network.newest.sent[0]?.id, error }) });
    await settled();
    clock.advance(HEARTBEAT_MS);
    expect(network.newest.sent.length).toBe(2);
    expect(states.at(-1)?.kind).toBe("open");
  });

  test("what is unanswered when the socket closes is given up", async () => {
    network.newest.onopen?.();
    const call = rpc?.call("dataset.list", {});
    network.newest.onclose?.();
    await expect(call).rejects.toBeInstanceOf(Disconnected);
  });

  test("a late word of a dropped socket changes nothing", () => {
    const old = network.newest;
    const late = old.onclose;
    connection.lost();
    connection.retryNow();
    expect(old.onclose).toBeNull();
    expect(late).not.toBeNull();
    expect(network.sockets.length).toBe(2);
  });

  test("stopped stays stopped", () => {
    network.newest.onopen?.();
    connection.stop();
    clock.advance(1e6);
    expect(network.sockets.length).toBe(1);
    expect(states.at(-1)).toEqual({ kind: "closed" });
  });
});
