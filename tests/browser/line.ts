// Simulates a network line between browser and server with limited bandwidth and a delay.
import { createServer, connect, type Server, type Socket } from "node:net";

export interface LineOptions {
  /** Delay of a byte and its answer together, in milliseconds. */
  roundTrip?: number;
  /** Bandwidth in megabits per second, for each direction; 0: unlimited. */
  rate?: number;
  /**
   * Seconds of data that the line buffers before it stops reading, like the buffer of a proxy. The operating system's
   * buffers come on top.
   */
  buffer?: number;
}

const LEAST_BUFFER = 32 << 10;
/** Size of a packet in milliseconds of the line's bandwidth. Timers have about this resolution. */
const PACKET_MS = 2;
const LEAST_PACKET = 1500;
const BYTES_PER_MEGABIT = 1e6 / 8;

/** Runs actions in the order of add(), none before its time. Separate timers could run in another order. */
class Schedule {
  private readonly due: { at: number; act: () => void }[] = [];

  add(at: number, act: () => void): void {
    this.due.push({ at, act });
    if (this.due.length === 1) this.wait(at);
  }

  private wait(at: number): void {
    setTimeout(() => this.run(), Math.max(0, at - performance.now()));
  }

  private run(): void {
    const now = performance.now();
    for (let next = this.due[0]; next !== undefined; next = this.due[0]) {
      if (next.at > now) {
        this.wait(next.at);
        return;
      }
      next.act();
      this.due.shift();
    }
  }
}

/** Forwards the bytes of one TCP connection in one direction, with bandwidth, delay and buffer of the line. */
class Direction {
  private readonly from: Socket;
  private readonly to: Socket;
  private readonly options: Required<LineOptions>;
  private readonly leaving = new Schedule();
  private readonly arriving = new Schedule();
  private freeAt = 0;
  private waiting = 0;
  /** Bytes that have left the line in this direction. */
  carried = 0;

  constructor(from: Socket, to: Socket, options: Required<LineOptions>) {
    [this.from, this.to, this.options] = [from, to, options];
    from.on("data", (bytes) => this.take(bytes));
    from.on("end", () => this.arrive(() => to.end()));
    from.on("error", () => to.destroy());
    from.on("close", () => this.arrive(() => to.destroy()));
  }

  private take(bytes: Buffer): void {
    const { rate } = this.options;
    const perMillisecond = (rate * BYTES_PER_MEGABIT) / 1000;
    const packet = rate === 0 ? bytes.length : Math.max(LEAST_PACKET, Math.round(PACKET_MS * perMillisecond));
    for (let from = 0; from < bytes.length; from += packet)
      this.carry(bytes.subarray(from, from + packet), rate === 0 ? 0 : 1 / perMillisecond);
    if (this.isFull) this.from.pause();
  }

  private get isFull(): boolean {
    const { rate, buffer } = this.options;
    return rate !== 0 && this.waiting > Math.max(LEAST_BUFFER, buffer * rate * BYTES_PER_MEGABIT);
  }

  private carry(bytes: Buffer, millisecondsPerByte: number): void {
    this.freeAt = Math.max(this.freeAt, performance.now()) + bytes.length * millisecondsPerByte;
    this.waiting += bytes.length;
    // Bytes under way no longer count as buffered.
    this.leaving.add(this.freeAt, () => {
      this.waiting -= bytes.length;
      if (!this.isFull) this.from.resume();
    });
    this.arrive(() => {
      this.carried += bytes.length;
      if (!this.to.destroyed) this.to.write(bytes);
    });
  }

  private arrive(what: () => void): void {
    this.arriving.add(Math.max(this.freeAt, performance.now()) + this.options.roundTrip / 2, what);
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

  /** Starts a line to a port of 127.0.0.1. */
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

  /** Bytes received from the server over all connections. */
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
