// with_chromium.ts COMMAND [ARGUMENT...]: runs a command with one browser for all of its processes, which read
// CIEL_CHROMIUM_ADDRESS. Exits with the command's status.
import { spawn } from "node:child_process";
import { launch } from "./chromium.ts";
import { freePort } from "./server.ts";

const [command = "", ...rest] = process.argv.slice(2);
const port = await freePort();
// The browser ignores these signals, so that the command ends first.
const ours = { handleSIGINT: false, handleSIGTERM: false, handleSIGHUP: false };
const browser = await launch({ args: [`--remote-debugging-port=${port}`], ...ours });
try {
  const env = { ...process.env, CIEL_CHROMIUM_ADDRESS: `http://127.0.0.1:${port}` };
  const child = spawn(command, rest, { stdio: "inherit", env });
  for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"] as const) process.on(signal, () => child.kill(signal));
  process.exitCode = await new Promise<number>((ended, failed) => {
    child.on("error", failed);
    child.on("exit", (code) => ended(code ?? 1));
  });
} finally {
  await browser.close();
}
