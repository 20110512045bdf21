// Client: a page in the browser, with the actions and checks that tests use.
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import type { Browser, BrowserContext, BrowserContextOptions, Locator, Page } from "./chromium.ts";
import { decodePng, type Picture } from "./png.ts";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
export const screenshots = process.env.CIEL_SCREENSHOTS ?? join(root, "build/screenshots");

export interface PageOptions {
  width?: number;
  height?: number;
  scale?: number;
  scheme?: "dark" | "light";
  touch?: boolean;
  /** Accepts a server certificate that no authority has signed. */
  selfSigned?: boolean;
  /** Script that runs in the page before its own scripts. */
  before?: string;
}

export interface Frame {
  frame: number;
  revision: number;
  /** Revision of the newest scene; NaN while the server has not accepted the newest change. */
  wanted: number;
  still: boolean;
  stream: string;
}

const contextOptions = (options: PageOptions): BrowserContextOptions => ({
  viewport: { width: options.width ?? 1024, height: options.height ?? 640 },
  deviceScaleFactor: options.scale ?? 1,
  colorScheme: options.scheme ?? "dark",
  hasTouch: options.touch ?? false,
  ignoreHTTPSErrors: options.selfSigned ?? false,
});

/** Browser context of a closed client, kept for reuse, and its page. null: the page cannot be reused. */
interface Left {
  context: BrowserContext;
  page: Page | null;
}

/** Contexts for reuse, by their options. Making a page with its process takes as long as half a test. */
const left = new WeakMap<Browser, Map<string, Left[]>>();

function leftFor(browser: Browser, options: PageOptions): Left[] {
  const all = left.get(browser) ?? new Map<string, Left[]>();
  left.set(browser, all);
  const key = JSON.stringify([contextOptions(options), options.before]);
  const free = all.get(key) ?? [];
  all.set(key, free);
  return free;
}

/** Resets the page to the state of a new one, except its context. Returns false if that is impossible. */
async function emptied(page: Page): Promise<boolean> {
  try {
    await page.evaluate(() => sessionStorage.clear()); // session storage belongs to the tab and survives page loads
  } catch {
    return false; // an error page has no session storage
  }
  page.removeAllListeners();
  await page.goto("about:blank");
  await page.mouse.move(0, 0);
  return true;
}

async function reset(page: Page, { viewport, colorScheme }: BrowserContextOptions): Promise<void> {
  if (viewport) await page.setViewportSize(viewport);
  await page.emulateMedia({ colorScheme: colorScheme ?? null });
}

/**
 * For how many milliseconds a test waits for the page. Transparent polygons take seconds a frame in software, half a
 * minute on a loaded machine, and the page answers nothing while it draws one.
 */
const patience = 120_000;

/** Returns the only layer that a patch changes; undefined if there is no patch. */
export function changedLayer(sent: Client["patches"][number] | undefined): Record<string, unknown> | undefined {
  if (sent === undefined) return undefined;
  assert.deepEqual(Object.keys(sent.patch), ["layers"]);
  const layers = Object.values(sent.patch.layers as Record<string, Record<string, unknown>>);
  assert.equal(layers.length, 1, JSON.stringify(sent.patch));
  return layers[0];
}

export class Client {
  readonly problems: string[] = [];
  readonly patches: { patch: Record<string, unknown>; gesture: string }[] = [];

  readonly page: Page;
  private readonly free: Left[];
  private readonly reusable: boolean;
  private readonly unanswered = new Set<number>();
  private patchListeners: { sent: () => void; answered: () => void } | null = null;

  private constructor(page: Page, free: Left[], reusable: boolean) {
    [this.page, this.free, this.reusable] = [page, free, reusable];
    page.setDefaultTimeout(patience);
    page.on("pageerror", (error) => this.problems.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error" && !/WebSocket|ERR_/.test(message.text())) this.problems.push(message.text());
    });
    page.on("websocket", (socket) => {
      socket.on("framesent", ({ payload }) => {
        const call = JSON.parse(String(payload)) as {
          id: number;
          method: string;
          params: Client["patches"][number];
        };
        if (call.method !== "scene.patch") return;
        this.patches.push(call.params);
        this.unanswered.add(call.id);
        this.patchListeners?.sent();
      });
      socket.on("framereceived", ({ payload }) => {
        if (typeof payload !== "string") return;
        const { id } = JSON.parse(payload) as { id?: number };
        if (id !== undefined && this.unanswered.delete(id)) this.patchListeners?.answered();
      });
    });
  }

  static async open(browser: Browser, address: string, options: PageOptions = {}): Promise<Client> {
    const free = leftFor(browser, options);
    const { context, page } = free.pop() ?? { context: await browser.newContext(contextOptions(options)), page: null };
    const { origin } = new URL(address);
    const client = new Client(page ?? (await context.newPage()), free, options.before === undefined);
    if (options.before !== undefined) await client.page.addInitScript(options.before);
    const devtools = await context.newCDPSession(client.page);
    await devtools.send("Storage.clearDataForOrigin", { origin, storageTypes: "all" });
    await devtools.detach();
    if (page !== null) await reset(page, contextOptions(options));
    await client.page.goto(address);
    return client;
  }

  /** Closes the client. A later client may reuse its context and, after a reset, its page. */
  async close(): Promise<void> {
    const context = this.page.context();
    const keeps = this.reusable && !this.page.isClosed() && (await emptied(this.page));
    const others = context.pages().filter((page) => !keeps || page !== this.page);
    await Promise.all(others.map((page) => page.close()));
    await context.clearPermissions();
    this.free.push({ context, page: keeps ? this.page : null });
  }

  get canvas(): Locator {
    return this.page.getByRole("application");
  }

  get isoValue(): Locator {
    return this.page.getByRole("slider", { name: /iso-value$/ }).first();
  }

  async value(): Promise<number> {
    return Number(await this.isoValue.getAttribute("aria-valuenow"));
  }

  private shown(): Promise<Frame> {
    return this.page.locator("[data-frame]").evaluate((element) => {
      const { frame, revision, wanted, still, stream } = (element as HTMLElement).dataset;
      return {
        frame: Number(frame),
        revision: Number(revision),
        wanted: Number(wanted),
        still: still === "true",
        stream: stream ?? "",
      };
    });
  }

  /**
   * Waits until the picture of the newest scene is complete and nothing changes for 150 ms. A still is needed, or
   * polygons. The page first draws two frames, so that it has sent what an action before this call changes.
   */
  async settled(stream = "image"): Promise<void> {
    const deadline = Date.now() + patience;
    await this.page.evaluate(
      () => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(() => drawn(undefined)))),
    );
    let last = -1;
    let since = Date.now();
    for (;;) {
      const frame = await this.shown();
      if (frame.frame !== last) [last, since] = [frame.frame, Date.now()];
      // Camera moves need no new polygons, so the frame's revision may be older.
      const current =
        stream === "geometry" ? !Number.isNaN(frame.wanted) : frame.still && frame.revision >= frame.wanted;
      const complete = frame.stream === stream && current;
      if (complete && Date.now() - since > 150) return;
      if (Date.now() > deadline) throw new Error(`no settled ${stream} picture: ${JSON.stringify(frame)}`);
      await this.page.waitForTimeout(30);
    }
  }

  async connected(): Promise<void> {
    await this.page.getByText("Connected", { exact: true }).waitFor({ timeout: 30_000 });
  }

  /** Waits until the iso-value is `value`. Another client may have changed it. */
  async reached(value: number): Promise<void> {
    await this.page.waitForFunction(
      (wanted) => document.querySelector("[role=slider]")?.getAttribute("aria-valuenow") === wanted,
      String(value),
    );
  }

  /** Waits until the page has sent `count` patches. It may have to ask the server before. */
  async patched(count = 1): Promise<void> {
    const deadline = Date.now() + patience;
    while (this.patches.length < count) {
      if (Date.now() > deadline) throw new Error(`${this.patches.length} of ${count} patches were sent`);
      await this.page.waitForTimeout(30);
    }
  }

  /** Performs an action and waits until the server has accepted the resulting scene. */
  async taken(act: () => Promise<unknown>): Promise<void> {
    const deadline = Date.now() + patience;
    let before = await this.wanted();
    for (; Number.isNaN(before); before = await this.wanted()) {
      if (Date.now() > deadline) throw new Error("the server does not accept the change before");
      await this.page.waitForTimeout(30);
    }
    await act();
    while (!((await this.wanted()) > before)) {
      if (Date.now() > deadline) throw new Error(`the scene is still that of revision ${before}`);
      await this.page.waitForTimeout(30);
    }
  }

  /** Returns the revision of the page's scene; NaN while the server has not accepted the newest change. */
  async wanted(): Promise<number> {
    return (await this.shown()).wanted;
  }

  /** Waits until the page's address contains the newest scene. The page writes it after a pause. */
  async addressed(): Promise<void> {
    let [address, since] = ["", Date.now()];
    while (Date.now() - since < 600) {
      if (this.page.url() !== address) [address, since] = [this.page.url(), Date.now()];
      await this.page.waitForTimeout(50);
    }
  }

  /** Returns the picture on the canvas, without overlays. */
  async picture(): Promise<Picture> {
    const hidden =
      ".ahead, .triad, .box-axes, .texts, .legends, .probe, .probe-mark, .busy, .toasts, .banner { visibility: hidden !important }";
    return decodePng(await this.canvas.screenshot({ style: hidden }));
  }

  /** Saves a screenshot for visual inspection. */
  async keep(name: string): Promise<void> {
    mkdirSync(screenshots, { recursive: true });
    writeFileSync(join(screenshots, `${name}.png`), await this.page.screenshot());
  }

  async drag(from: [number, number], to: [number, number], steps = 8): Promise<void> {
    await this.page.mouse.move(...from);
    await this.page.mouse.down();
    await this.page.mouse.move(...to, { steps });
    await this.page.mouse.up();
  }

  /** Drags on the canvas. Positions are shares of its width and height. */
  async dragCanvas(from: [number, number], to: [number, number], steps?: number): Promise<void> {
    const box = await this.canvas.boundingBox();
    if (box === null) throw new Error("the canvas is not on the page");
    const at = ([x, y]: [number, number]): [number, number] => [box.x + x * box.width, box.y + y * box.height];
    await this.drag(at(from), at(to), steps);
  }

  /** Drags the handle of the iso-value. `to`: share of the array's range. */
  async dragIso(to: number, steps = 12): Promise<void> {
    const handle = await this.isoValue.boundingBox();
    const track = await this.page.locator(".histogram-track").first().boundingBox();
    if (handle === null || track === null) throw new Error("the histogram is not on the page");
    const y = track.y + track.height / 2;
    await this.drag([handle.x + handle.width / 2, y], [track.x + to * track.width, y], steps);
  }

  /** Calls `sent` and `answered` for each patch from now on. */
  onPatch({ sent, answered }: { sent: () => void; answered: () => void }): void {
    this.patchListeners = { sent, answered };
  }

  toast(text: string | RegExp): Locator {
    return this.page.locator(".toast", { hasText: text });
  }

  button(name: string | RegExp, exact = false): Locator {
    return this.page.getByRole("button", { name, exact });
  }

  async choose(dataset: string): Promise<void> {
    await this.page.getByLabel("Dataset", { exact: true }).selectOption(dataset);
    await this.page.waitForFunction((name) => document.title.startsWith(`${name} `), dataset);
  }
}
