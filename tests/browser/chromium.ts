// Debian's Chromium by playwright-core, which lives with the web client's build tools.
import { createRequire } from "node:module";
import type * as Playwright from "playwright-core";

const require = createRequire(new URL("../../webclient/package.json", import.meta.url));
const playwright = require("playwright-core") as typeof Playwright;

export type { Browser, BrowserContext, BrowserContextOptions, CDPSession, Locator, Page } from "playwright-core";

const FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

export function launch({ args = [], ...more }: Playwright.LaunchOptions = {}): Promise<Playwright.Browser> {
  const executablePath = process.env.CIEL_CHROMIUM ?? "/usr/bin/chromium";
  return playwright.chromium.launch({
    executablePath,
    args: [...FLAGS, "--enable-unsafe-swiftshader", ...args],
    ...more,
  });
}

/** The browser of with_chromium.ts, which closes no more than the contexts made here; else one of our own. */
export function browser(): Promise<Playwright.Browser> {
  const shared = process.env.CIEL_CHROMIUM_ADDRESS ?? "";
  return shared === "" ? launch() : playwright.chromium.connectOverCDP(shared);
}
