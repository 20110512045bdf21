// Starts Debian's Chromium by playwright-core, which is installed in webclient/node_modules.
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

/**
 * Connects to the browser of with_chromium.ts if there is one, otherwise launches a new one. Closing the connection
 * leaves the shared browser running.
 */
export function browser(): Promise<Playwright.Browser> {
  const shared = process.env.CIEL_CHROMIUM_ADDRESS ?? "";
  return shared === "" ? launch() : playwright.chromium.connectOverCDP(shared);
}
