// JSON-RPC 2.0 over one text channel: calls, answers, notifications. It knows no socket.
import type { Methods, Notifications } from "../generated/protocol";

export type MethodName = keyof Methods;
export type Params<M extends MethodName> = Methods[M]["params"];
export type Result<M extends MethodName> = Methods[M]["result"];
export type NotificationName = keyof Notifications;

export class RpcError extends Error {
  constructor(
    readonly code: number,
    message: string,
    readonly data: unknown,
  ) {
    super(message);
    this.name = "RpcError";
  }
}

/** The connection ended before the answer came. */
export class Disconnected extends Error {
  constructor() {
    super("The connection ended before the server answered");
    this.name = "Disconnected";
  }
}

interface Pending {
  resolve: (result: unknown) => void;
  reject: (error: Error) => void;
}

interface Message {
  id?: number | null;
  method?: string;
  params?: unknown;
  result?: unknown;
  error?: { code: number; message: string; data?: unknown };
}

export class Rpc {
  private nextId = 1;
  private readonly pending = new Map<number, Pending>();

  constructor(
    private readonly send: (text: string) => void,
    private readonly onNotification: (name: string, params: unknown) => void,
  ) {}

  call<M extends MethodName>(method: M, params: Params<M>): Promise<Result<M>> {
    const id = this.nextId++;
    return new Promise<Result<M>>((resolve, reject) => {
      this.pending.set(id, { resolve: resolve as (result: unknown) => void, reject });
      this.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
    });
  }

  notify<M extends MethodName>(method: M, params: Params<M>): void {
    this.send(JSON.stringify({ jsonrpc: "2.0", method, params }));
  }

  receive(text: string): void {
    const message = JSON.parse(text) as Message;
    if (message.method !== undefined) {
      this.onNotification(message.method, message.params);
      return;
    }
    const call = typeof message.id === "number" ? this.pending.get(message.id) : undefined;
    if (call === undefined) return; // an answer to a call that was given up
    this.pending.delete(message.id as number);
    const error = message.error;
    if (error === undefined) call.resolve(message.result);
    else call.reject(new RpcError(error.code, error.message, error.data));
  }

  /** Rejects whatever is unanswered: a closed socket answers no more. */
  close(): void {
    for (const call of this.pending.values()) call.reject(new Disconnected());
    this.pending.clear();
  }
}
