// with_chromium.ts COMMAND [ARGUMENT...]: one browser for all processes of the command, which find it by
// CIEL_CHROMIUM_ADDRESS. Exits as the command does.
import { spawn } from "node:child_process";
import { launch } from "./chromium.ts";
import { freePort } from "./server.ts";

const [command = "", ...rest] = process.argv.slice(2);
const port = await freePort();
const browser = await launch([`--remote-debugging-port=${port}`]);
try {
  const env = { ...process.env, CIEL_CHROMIUM_ADDRESS: `http://127.0.0.1:${port}` };
  const child = spawn(command, rest, { stdio: "inherit", env });
  process.exitCode = await new Promise<number>((ended, failed) => {
    child.on("error", failed);
    child.on("exit", (code) => ended(code ?? 1));
  });
} finally {
  await browser.close();
}
