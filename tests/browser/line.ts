// A line between browser and server: it takes time, and lets through so many bytes a second each way.
import { createServer, connect, type Server, type Socket } from "node:net";

export interface LineOptions {
  /** Of a byte there and its answer back, milliseconds. */
  roundTrip?: number;
  /** Megabits a second; 0: as many as there are. */
  rate?: number;
  /** Seconds of bytes that wait in the line before it takes no more: a proxy that buffers has many. The system's own
   * buffers come on top. */
  buffer?: number;
}

const LEAST_BUFFER = 32 << 10;

/** One direction of one connection. */
class Direction {
  private readonly from: Socket;
  private readonly to: Socket;
  private readonly options: Required<LineOptions>;
  private freeAt = 0;
  private waiting = 0;
  /** Bytes that have left it. */
  carried = 0;

  constructor(from: Socket, to: Socket, options: Required<LineOptions>) {
    [this.from, this.to, this.options] = [from, to, options];
    from.on("data", (bytes) => this.take(bytes));
    from.on("end", () => this.after(this.freeAt, () => to.end()));
    from.on("error", () => to.destroy());
    from.on("close", () => this.after(this.freeAt, () => to.destroy()));
  }

  private take(bytes: Buffer): void {
    const { rate, buffer } = this.options;
    const perMillisecond = (rate * 1e6) / 8 / 1000;
    this.freeAt = Math.max(this.freeAt, performance.now()) + (rate === 0 ? 0 : bytes.length / perMillisecond);
    this.waiting += bytes.length;
    if (rate !== 0 && this.waiting > Math.max(LEAST_BUFFER, buffer * 1000 * perMillisecond)) this.from.pause();
    // What has left the queue is on its way, and takes no room in it.
    setTimeout(() => {
      this.waiting -= bytes.length;
      this.from.resume();
    }, this.freeAt - performance.now());
    this.after(this.freeAt, () => {
      this.carried += bytes.length;
      if (!this.to.destroyed) this.to.write(bytes);
    });
  }

  private after(time: number, what: () => void): void {
    setTimeout(what, Math.max(0, time + this.options.roundTrip / 2 - performance.now()));
  }
}

export class Line {
  private readonly directions: Direction[] = [];
  private readonly sockets = new Set<Socket>();
  private readonly server: Server;
  private readonly target: number;
  private readonly options: Required<LineOptions>;

  private constructor(server: Server, target: number, options: LineOptions) {
    [this.server, this.target] = [server, target];
    this.options = { roundTrip: 0, rate: 0, buffer: 0, ...options };
    server.on("connection", (client) => this.join(client));
  }

  /** To a port of the loopback. */
  static async to(port: number, options: LineOptions): Promise<Line> {
    const server = createServer();
    const line = new Line(server, port, options);
    await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
    return line;
  }

  get port(): number {
    const address = this.server.address();
    if (address === null || typeof address === "string") throw new Error("the line is closed");
    return address.port;
  }

  /** Bytes that have come from the server. */
  get received(): number {
    return this.directions.reduce((sum, { carried }) => sum + carried, 0);
  }

  async close(): Promise<void> {
    for (const socket of this.sockets) socket.destroy();
    await new Promise((done) => this.server.close(done));
  }

  private join(client: Socket): void {
    const server = connect(this.target, "127.0.0.1");
    for (const socket of [client, server]) {
      socket.setNoDelay(true);
      this.sockets.add(socket);
      socket.on("close", () => this.sockets.delete(socket));
    }
    new Direction(client, server, this.options);
    this.directions.push(new Direction(server, client, this.options));
  }
}
