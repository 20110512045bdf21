// JSON-RPC 2.0 over a text channel. An answer that is too long for a WebSocket message is fetched by HTTP POST.
import { ErrorCode, PROTOCOL, type Methods, type Notifications } from "../generated/protocol";

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

/** Error of a call whose answer had not arrived when the connection ended. */
export class Disconnected extends Error {
  constructor() {
    super("The connection ended before the server answered");
    this.name = "Disconnected";
  }
}

export type Post = (request: string, signal?: AbortSignal) => Promise<string>;

interface Pending {
  method: MethodName;
  params: unknown;
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

/** Methods that are always called by HTTP POST, because the result may exceed the limit of a WebSocket message. */
const BY_POST = new Set<MethodName>(["picture.render", "surface.export"]);

/**
 * Method to call by POST after an answer that was too long for a WebSocket message. Absent: the same method. Undo and
 * redo must not be repeated.
 */
const ASKED_AGAIN_AS: Partial<Record<MethodName, MethodName>> = {
  "scene.undo": "scene.get",
  "scene.redo": "scene.get",
};

/** Without `id`: a notification. A server with another major version of the protocol refuses the request. */
const requestText = (method: MethodName, params: unknown, id?: number): string =>
  JSON.stringify({ jsonrpc: "2.0", protocol: PROTOCOL, id, method, params });

export class Rpc {
  private nextId = 1;
  private readonly pending = new Map<number, Pending>();

  constructor(
    private readonly send: (text: string) => void,
    private readonly onNotification: (name: string, params: unknown) => void,
    private readonly post: Post,
  ) {}

  /** `signal` cancels a call that is made by POST. */
  call<M extends MethodName>(method: M, params: Params<M>, signal?: AbortSignal): Promise<Result<M>> {
    if (BY_POST.has(method)) return this.byPost(method, params, signal) as Promise<Result<M>>;
    const id = this.nextId++;
    return new Promise<Result<M>>((resolve, reject) => {
      this.pending.set(id, { method, params, resolve: resolve as (result: unknown) => void, reject });
      this.send(requestText(method, params, id));
    });
  }

  notify<M extends MethodName>(method: M, params: Params<M>): void {
    this.send(requestText(method, params));
  }

  receive(text: string): void {
    const message = JSON.parse(text) as Message;
    if (message.method !== undefined) {
      this.onNotification(message.method, message.params);
      return;
    }
    const call = typeof message.id === "number" ? this.pending.get(message.id) : undefined;
    if (call === undefined) return; // the answer to an unknown call
    this.pending.delete(message.id as number);
    if (message.error?.code === ErrorCode.AnswerTooLong)
      this.byPost(ASKED_AGAIN_AS[call.method] ?? call.method, call.params).then(call.resolve, call.reject);
    else settle(message, call);
  }

  private async byPost(method: MethodName, params: unknown, signal?: AbortSignal): Promise<unknown> {
    const text = await this.post(requestText(method, params, this.nextId++), signal);
    return new Promise((resolve, reject) => settle(JSON.parse(text) as Message, { resolve, reject }));
  }

  /** Rejects all unanswered calls with Disconnected. Call when the socket has closed. */
  close(): void {
    for (const call of this.pending.values()) call.reject(new Disconnected());
    this.pending.clear();
  }
}

function settle({ result, error }: Message, call: Pick<Pending, "resolve" | "reject">): void {
  if (error === undefined) call.resolve(result);
  else call.reject(new RpcError(error.code, error.message, error.data));
}
