// A WebSocket that reconnects, with exponential back-off, jitter and a heartbeat. Reports the state of the connection.
import type { ConnectionState } from "../model/state";
import { Disconnected, Rpc, type Post } from "./rpc";

export interface SocketLike {
  binaryType: string;
  onopen: (() => void) | null;
  onclose: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  send(data: string): void;
  close(): void;
}

export interface ConnectionEvents {
  state(state: ConnectionState): void;
  /** A new socket is open. The server has forgotten the views of the previous connection. */
  opened(rpc: Rpc): void;
  notification(name: string, params: unknown): void;
  binary(message: ArrayBuffer): void;
  roundTrip(milliseconds: number): void;
}

/** Source of time and random numbers. Tests replace it. */
export interface Clock {
  now(): number;
  random(): number;
  setTimeout(callback: () => void, milliseconds: number): number;
  clearTimeout(timer: number): void;
}

export const FIRST_RETRY_MS = 500;
export const LAST_RETRY_MS = 15_000;
export const HEARTBEAT_MS = 10_000;
export const CONNECT_TIMEOUT_MS = 10_000;

/**
 * Returns milliseconds. Up to a quarter of the delay is subtracted at random, so that the clients of a server do not
 * all reconnect at the same time. `random`: from 0 to 1.
 */
export function retryDelay(attempt: number, random: number): number {
  const delay = Math.min(LAST_RETRY_MS, FIRST_RETRY_MS * 2 ** Math.min(attempt, 16));
  return delay * (0.75 + 0.25 * random);
}

export class Connection {
  private socket: SocketLike | null = null;
  private openRpc: Rpc | null = null;
  private attempt = 0;
  private timer: number | null = null;

  constructor(
    private readonly open: () => SocketLike,
    private readonly post: Post,
    private readonly events: ConnectionEvents,
    private readonly clock: Clock,
  ) {}

  /** null while no socket is open. */
  get rpc(): Rpc | null {
    return this.openRpc;
  }

  start(): void {
    this.connect();
  }

  stop(): void {
    this.drop();
    this.events.state({ kind: "closed" });
  }

  retryNow(): void {
    if (this.socket === null) this.connect();
  }

  /** Call when the browser has lost the network. Closes the socket without waiting for the heartbeat. */
  lost(): void {
    if (this.socket !== null) this.ended();
  }

  private connect(): void {
    this.drop();
    this.events.state({ kind: "connecting", attempt: this.attempt });
    const socket = this.open();
    const rpc = new Rpc(
      (text) => socket.send(text),
      (name, params) => this.events.notification(name, params),
      this.post,
    );
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.attempt = 0;
      this.openRpc = rpc;
      this.clearTimer();
      this.events.opened(rpc);
      this.events.state({ kind: "open" });
      this.heartbeat(rpc);
    };
    socket.onmessage = (event) => {
      if (typeof event.data === "string") rpc.receive(event.data);
      else this.events.binary(event.data as ArrayBuffer);
    };
    socket.onclose = () => this.ended();
    this.socket = socket;
    this.setTimer(() => this.ended(), CONNECT_TIMEOUT_MS);
  }

  // Detects a dead connection by an unanswered call. A socket does not close when a network cable is pulled.
  private heartbeat(rpc: Rpc): void {
    const sent = this.clock.now();
    this.setTimer(() => this.ended(), HEARTBEAT_MS);
    rpc.call("server.info", {}).then(
      () => {
        if (this.rpc !== rpc) return;
        this.events.roundTrip(this.clock.now() - sent);
        this.setTimer(() => this.heartbeat(rpc), HEARTBEAT_MS);
      },
      (error: unknown) => {
        // An error answer also proves that the connection works.
        if (this.rpc === rpc && !(error instanceof Disconnected))
          this.setTimer(() => this.heartbeat(rpc), HEARTBEAT_MS);
      },
    );
  }

  private ended(): void {
    this.drop();
    const delay = retryDelay(this.attempt, this.clock.random());
    this.events.state({ kind: "waiting", attempt: this.attempt, retryAt: this.clock.now() + delay });
    this.attempt += 1;
    this.setTimer(() => this.connect(), delay);
  }

  private drop(): void {
    this.clearTimer();
    const { socket, rpc } = this;
    this.socket = null;
    this.openRpc = null;
    if (socket !== null) {
      socket.onopen = socket.onclose = socket.onmessage = null;
      socket.close();
    }
    rpc?.close();
  }

  private setTimer(callback: () => void, milliseconds: number): void {
    this.clearTimer();
    this.timer = this.clock.setTimeout(callback, milliseconds);
  }

  private clearTimer(): void {
    if (this.timer !== null) this.clock.clearTimeout(this.timer);
    this.timer = null;
  }
}
