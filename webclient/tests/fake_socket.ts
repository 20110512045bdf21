// Fake socket, network and clock. Tests decide when messages arrive and when time passes.
import type { Clock, SocketLike } from "../src/server/connection";

export class FakeSocket implements SocketLike {
  binaryType = "";
  onopen: (() => void) | null = null;
  onclose: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  readonly sent: { id?: number; method: string; params: unknown }[] = [];
  closed = false;

  send(data: string): void {
    this.sent.push(JSON.parse(data) as FakeSocket["sent"][number]);
  }

  close(): void {
    this.closed = true;
  }

  /** Answers the newest call of the method, or of any method if none is given. Then lets pending promises run. */
  answer(result: unknown, method?: string): Promise<void> {
    return this.reply({ result }, method);
  }

  refuse(error: { code: number; message: string; data: unknown }, method: string): Promise<void> {
    return this.reply({ error }, method);
  }

  private async reply(answer: object, method?: string): Promise<void> {
    const call = this.sent.filter((message) => method === undefined || message.method === method).at(-1);
    this.onmessage?.({ data: JSON.stringify({ jsonrpc: "2.0", id: call?.id, ...answer }) });
    await settled();
  }

  calls(method: string): FakeSocket["sent"] {
    return this.sent.filter((message) => message.method === method);
  }
}

/** Opens fake sockets and keeps all of them. */
export class FakeNetwork {
  readonly sockets: FakeSocket[] = [];

  readonly open = (): FakeSocket => {
    this.sockets.push(new FakeSocket());
    return this.newest;
  };

  get newest(): FakeSocket {
    const socket = this.sockets.at(-1);
    if (socket === undefined) throw new Error("no socket was opened");
    return socket;
  }
}

/** Resolves after all pending promises have run. */
export const settled = (): Promise<void> => new Promise((done) => setTimeout(done, 0));

export class FakeClock implements Clock {
  private time = 1_000_000;
  private nextTimer = 1;
  private readonly timers = new Map<number, { at: number; callback: () => void }>();

  now(): number {
    return this.time;
  }

  random(): number {
    return 1;
  }

  setTimeout(callback: () => void, milliseconds: number): number {
    const timer = this.nextTimer++;
    this.timers.set(timer, { at: this.time + milliseconds, callback });
    return timer;
  }

  clearTimeout(timer: number): void {
    this.timers.delete(timer);
  }

  advance(milliseconds: number): void {
    this.time += milliseconds;
    for (const [timer, { at, callback }] of [...this.timers]) {
      if (at > this.time) continue;
      this.timers.delete(timer);
      callback();
    }
  }
}
