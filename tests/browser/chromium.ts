// Starts Debian's Chromium by playwright-core, which is installed in webclient/node_modules. The default is the program
// without windows, which has the same engine and takes a quarter less CPU time. CIEL_CHROMIUM: another program.
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
  const executablePath = process.env.CIEL_CHROMIUM ?? "/usr/bin/chromium-headless-shell";
  return playwright.chromium.launch({
    executablePath,
    args: [...FLAGS, "--enable-unsafe-swiftshader", ...args],
    ...more,
  });
}
