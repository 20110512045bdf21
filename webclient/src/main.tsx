// Creates the model, the server connection, the view and the commands, connects them, and renders the shell.
import { render } from "preact";
import { Commands } from "./commands/commands";
import layoutModule from "./generated/annotations.wasm?url";
import { Links } from "./commands/links";
import { savedSteps, savedStream, savedTheme, saveSteps, tabSession } from "./commands/preferences";
import { CanvasSize } from "./model/canvas_size";
import { makeModel } from "./model/model";
import { PageContext } from "./panels/context";
import { Shell } from "./panels/shell/shell";
import { hideToken } from "./server/browser_socket";
import { Server } from "./server/server";
import "./style/tokens.css";
import "./style/layout.css";
import "./style/controls.css";
import "./style/panels.css";
import "./style/annotations.css";
import "./style/overlays.css";
import "./style/colors.css";
import { View } from "./view/view";
import { startLayoutModule } from "./wasm/layout_module";

hideToken();
const model = makeModel({ theme: savedTheme(), streamChoice: savedStream() });
const links = new Links(model, () => server);
const tab = tabSession();
const server: Server = new Server(model, new CanvasSize(model.canvasSize), tab, {
  background: () => commands.page.background(),
  link: () => links.first,
  frames: () => view.presenter,
  clearPicture: () => view.clear(),
  stopPlaying: () => commands.time.stop(),
  sceneChanged: () => links.writeSoon(),
});
const view: View = new View(model, server, (header, bytes) => {
  server.presented(header, bytes);
  commands.time.presented(header.time);
});
const commands: Commands = new Commands(model, server, view, links);

async function start(root: HTMLElement): Promise<void> {
  try {
    const response = await fetch(layoutModule);
    if (!response.ok) throw new Error(`the server answered ${response.status} for ${layoutModule}`);
    await startLayoutModule(await response.arrayBuffer());
  } catch (problem) {
    const reason = problem instanceof Error ? problem.message : String(problem);
    root.textContent = `CIEL cannot start its WebAssembly module: ${reason}. Reload the page, or allow WebAssembly in the browser.`;
    return;
  }
  render(
    <PageContext.Provider value={{ model, commands }}>
      <Shell />
    </PageContext.Provider>,
    root,
  );
}

// Keeps the undo steps in a reload of the page, because the server may restart meanwhile and lose its steps.
server.editor.restoreSteps(savedSteps(tab.id));
window.addEventListener("pagehide", () => saveSteps(tab.id, server.editor.stepsAsText()));

const root = document.getElementById("app");
if (root !== null) void start(root);
