// through_proxy.ts ADDRESS PICTURE: opens the page behind a TLS proxy with a self-signed certificate. Fails if it shows
// no surface.
import { launch } from "./chromium.ts";
import { Client } from "./page.ts";
import { decodePng, hue, share } from "./png.ts";

const [address = "", path = ""] = process.argv.slice(2);
const browser = await launch();
try {
  const client = await Client.open(browser, address, { width: 1280, height: 720, selfSigned: true });
  await client.settled();
  await client.connected();
  const colored = share(decodePng(await client.page.screenshot({ path })), (color) => hue(color) !== null);
  if (colored < 0.05) throw new Error(`only ${(100 * colored).toFixed(1)} % of the page has a color: no surface`);
  if (client.problems.length > 0) throw new Error(client.problems.join("; "));
} finally {
  await browser.close();
}
