// line_table.ts [--seconds N] [--streams png,jpeg,geometry,auto] [--round-trips 0,50,200] [--rates 10,100] [--buffer
// SECONDS]: measures dragging over simulated lines. CIEL_BROWSER_DATA names the dataset, CIEL_WEBCLIENT another build
// of the page. Columns: pictures per second; age, the milliseconds from the newest move in a picture to its display;
// kB/s from the server. Camera moves that the page draws itself from polygons have no age.
import { parseArgs } from "node:util";
import { launch, type Browser } from "./chromium.ts";
import { Line } from "./line.ts";
import { Client } from "./page.ts";
import { datasets, Server } from "./server.ts";
import { isoFragment } from "./stage.ts";

interface Watch {
  /** Time of each patch (performance.now), by the revision that it became. */
  sent: Record<number, number>;
  shown: { revision: number; at: number; still: boolean }[];
  /** Times of animation frames in which the page drew polygons. */
  drawn: number[];
}

declare global {
  interface Window {
    watch: Watch;
  }
}

/** Runs in the page: records patches, shown frames and drawings in window.watch. */
function listen(): void {
  const watch: Watch = { sent: {}, shown: [], drawn: [] };
  window.watch = watch;
  const asked = new Map<number, number>();
  const send = Reflect.get(WebSocket.prototype, "send") as (data: unknown) => void;
  WebSocket.prototype.send = function (this: WebSocket & { heard?: boolean }, data) {
    if (this.heard !== true)
      this.addEventListener("message", ({ data: text }: MessageEvent<unknown>) => {
        if (typeof text !== "string") return;
        const { id, result } = JSON.parse(text) as { id?: number; result?: { revision?: number } };
        const since = asked.get(id ?? -1);
        if (since !== undefined && result?.revision !== undefined) watch.sent[result.revision] = since;
      });
    this.heard = true;
    const { id, method } = JSON.parse(data as string) as { id?: number; method: string };
    if (method === "scene.patch" && id !== undefined) asked.set(id, performance.now());
    send.call(this, data);
  };
  const draw = Reflect.get(WebGL2RenderingContext.prototype, "drawElements") as (...of: unknown[]) => void;
  let frame = false;
  WebGL2RenderingContext.prototype.drawElements = function (...of) {
    if (!frame) {
      frame = true;
      watch.drawn.push(performance.now());
      requestAnimationFrame(() => (frame = false));
    }
    draw.apply(this, of);
  };
  const look = (): void => {
    const { frame: number, revision, still } = document.querySelector<HTMLElement>("[data-frame]")?.dataset ?? {};
    if (number === undefined || number === last) return;
    last = number;
    watch.shown.push({ revision: Number(revision), at: performance.now(), still: still === "true" });
  };
  let last = "";
  new MutationObserver(look).observe(document, { subtree: true, attributes: true, attributeFilter: ["data-frame"] });
}

const { values } = parseArgs({
  options: {
    seconds: { type: "string", default: "6" },
    streams: { type: "string", default: "png,jpeg,geometry,auto" },
    gestures: { type: "string", default: "iso,camera" },
    "round-trips": { type: "string", default: "0,50,200" },
    rates: { type: "string", default: "10,100" },
    buffer: { type: "string", default: "0" },
  },
});
const seconds = Number(values.seconds);
const STORED: Record<string, string> = { png: "image" };

type Gesture = (client: Client, turn: number) => [number, number];

/** Gestures of the measurement. Each returns the pointer's position, which goes back and forth once in four seconds. */
async function hands(client: Client): Promise<Record<string, Gesture>> {
  const canvas = await client.canvas.boundingBox();
  const track = await client.page.locator(".histogram-track").first().boundingBox();
  const handle = await client.isoValue.boundingBox();
  if (canvas === null || track === null || handle === null) throw new Error("nothing to take hold of");
  const y = track.y + track.height / 2;
  const start = (handle.x + handle.width / 2 - track.x) / track.width;
  return {
    iso: (_, turn) => [track.x + track.width * (start + (0.9 - start) * turn), y],
    camera: (_, turn) => [canvas.x + canvas.width * (0.3 + 0.4 * turn), canvas.y + canvas.height / 2],
  };
}

async function drag(client: Client, line: Line, hand: Gesture): Promise<Watch & { kilobytes: number }> {
  const { mouse } = client.page;
  await mouse.move(...hand(client, 0));
  await mouse.down();
  const begun = performance.now();
  let received = 0;
  let from = 0;
  for (;;) {
    const now = performance.now() - begun;
    // The first second is not measured: the server adapts to the line.
    if (from === 0 && now > 1000) {
      received = line.received;
      from = await client.page.evaluate(() => performance.now());
    }
    if (now > 1000 + 1000 * seconds) break;
    await mouse.move(...hand(client, 1 - Math.abs(((now / 2000) % 2) - 1)));
    await new Promise((done) => setTimeout(done, 8));
  }
  const kilobytes = (line.received - received) / 1000 / seconds;
  const watch = await client.page.evaluate(() => window.watch);
  await mouse.up();
  return {
    kilobytes,
    sent: watch.sent,
    shown: watch.shown.filter(({ at, still }) => at >= from && !still),
    drawn: watch.drawn.filter((at) => at >= from),
  };
}

const quantile = (sorted: number[], part: number): string => {
  const value = sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
  return value === undefined ? "-" : value.toFixed(0);
};

async function rows(browser: Browser, server: Server, stream: string, roundTrip: number, rate: number): Promise<void> {
  const line = await Line.to(server.port, { roundTrip, rate, buffer: Number(values.buffer) });
  const before = `(${listen.toString()})(); localStorage.setItem("ciel.stream", "${STORED[stream] ?? stream}");`;
  const address = `http://127.0.0.1:${line.port}/${await isoFragment(server)}`;
  const client = await Client.open(browser, address, { width: 1280, height: 720, before });
  try {
    await client.page.waitForFunction(() => window.watch.shown.length > 0, undefined, { timeout: 60_000 });
    await client.page.locator(".histogram-track").first().waitFor({ timeout: 60_000 });
    await client.page.waitForTimeout(3000 + 2 * roundTrip);
    const gestures = await hands(client);
    for (const name of values.gestures.split(",")) {
      const hand = gestures[name];
      if (hand === undefined) throw new Error(`there is no gesture ${name}`);
      const { shown, drawn, sent, kilobytes } = await drag(client, line, hand);
      const ages = shown.flatMap(({ revision, at }) => {
        const since = sent[revision];
        return since === undefined ? [] : [at - since];
      });
      ages.sort((a, b) => a - b);
      const own = shown.length === 0 && drawn.length > 0;
      const fps = (own ? drawn : shown).length / seconds;
      const cells = [
        name,
        stream,
        roundTrip,
        rate,
        fps.toFixed(1),
        quantile(ages, 0.5),
        quantile(ages, 0.95),
        kilobytes.toFixed(0),
      ];
      console.log(`| ${cells.join(" | ")} |`);
      await client.page.waitForTimeout(2000 + 2 * roundTrip);
    }
  } finally {
    await client.close();
    await line.close();
  }
}

const server = await Server.started(datasets(), { samples: 4 });
const browser = await launch();
try {
  console.log(
    "| gesture | stream | round trip, ms | Mbit/s | fps | age p50, ms | age p95, ms | kB/s |\n|---|---|---|---|---|---|---|---|",
  );
  for (const rate of values.rates.split(",").map(Number))
    for (const roundTrip of values["round-trips"].split(",").map(Number))
      for (const stream of values.streams.split(",")) await rows(browser, server, stream, roundTrip, rate);
} finally {
  await browser.close();
  await server.stop();
}
