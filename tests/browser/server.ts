// Runs `ciel serve` on a free port of 127.0.0.1, and ends it.
import { spawn, type ChildProcess } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { createServer } from "node:net";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const binary = process.env.CIEL_BINARY ?? join(root, "build/ciel");
export const webclient = process.env.CIEL_WEBCLIENT ?? join(root, "webclient/dist");

/** Datasets of an environment variable: paths separated by colons, each a dataset or a folder of datasets. */
export function datasets(variable = "CIEL_BROWSER_DATA"): string[] {
  const paths = (process.env[variable] ?? "").split(":").filter((path) => path !== "");
  return paths.flatMap((path) =>
    path.replace(/\/$/, "").endsWith(".ciel") || !existsSync(path)
      ? [path]
      : readdirSync(path).flatMap((name) => (name.endsWith(".ciel") ? [join(path, name)] : [])),
  );
}

export const nameOf = (path: string): string =>
  path
    .replace(/\/$/, "")
    .replace(/^.*\//, "")
    .replace(/\.ciel$/, "");

export async function freePort(): Promise<number> {
  const probe = createServer();
  await new Promise<void>((done) => probe.listen(0, "127.0.0.1", done));
  const address = probe.address();
  await new Promise((done) => probe.close(done));
  if (address === null || typeof address === "string") throw new Error("no free port");
  return address.port;
}

export interface ServerOptions {
  prefix?: string;
  token?: string;
  /** Samples per pixel of stills. Default 1: few tests depend on smooth edges, and software drawing is slow. */
  samples?: number;
}

export class Server {
  private process: ChildProcess | null = null;
  log = "";

  readonly port: number;
  private readonly data: string[];
  private readonly prefix: string;
  private readonly token: string;
  private readonly samples: number;

  private constructor(port: number, data: string[], { prefix = "", token = "", samples = 1 }: ServerOptions) {
    this.port = port;
    this.data = data;
    this.prefix = prefix;
    this.token = token;
    this.samples = samples;
  }

  static async started(data: string[], options: ServerOptions = {}): Promise<Server> {
    const server = new Server(await freePort(), data, options);
    await server.start();
    return server;
  }

  get address(): string {
    return `http://127.0.0.1:${this.port}${this.prefix}/`;
  }

  /** Starts the server and resolves when it listens. Does nothing if it is running. */
  async start(): Promise<void> {
    if (this.process?.exitCode === null) return;
    const prefix = this.prefix === "" ? [] : ["--prefix", this.prefix];
    const drawing = ["--still-samples", String(this.samples)];
    const options = [
      "serve",
      ...this.data,
      "--port",
      String(this.port),
      "--webclient",
      webclient,
      ...prefix,
      ...drawing,
    ];
    const child = spawn(binary, options, {
      stdio: ["ignore", "pipe", "pipe"],
      env: this.token === "" ? process.env : { ...process.env, CIEL_TOKEN: this.token },
    });
    this.process = child;
    await new Promise<void>((listening, failed) => {
      const heard = (text: Buffer): void => {
        this.log += text.toString();
        if (this.log.includes("listening on")) listening();
      };
      this.log = "";
      child.stdout.on("data", heard);
      child.stderr.on("data", heard);
      child.on("error", failed);
      child.on("exit", (code) => failed(new Error(`ciel serve ended with ${String(code)}:\n${this.log}`)));
    });
  }

  /** Suspends the server: it answers nothing until goOn(). */
  pause(): void {
    this.process?.kill("SIGSTOP");
  }

  goOn(): void {
    this.process?.kill("SIGCONT");
  }

  /** Ends the server and waits for its exit. To a browser, SIGKILL looks like a crash. */
  async stop(signal: "SIGTERM" | "SIGKILL" = "SIGTERM"): Promise<void> {
    const child = this.process;
    this.process = null;
    if (child === null || child.exitCode !== null) return;
    const ended = new Promise((done) => child.once("exit", done));
    child.kill(signal);
    await ended;
  }
}
