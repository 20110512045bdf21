// Wires the page: the model, the server, the view, the commands. Nothing else knows all four.
import { render } from "preact";
import { Commands } from "./commands/commands";
import { Links } from "./commands/links";
import { savedStream, savedTheme, tabSession } from "./commands/preferences";
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

hideToken();
const model = makeModel({ theme: savedTheme(), streamChoice: savedStream() });
const links = new Links(model, () => server);
const server: Server = new Server(model, new CanvasSize(), tabSession(), {
  background: () => commands.page.background(),
  link: () => links.first,
  frames: () => view.presenter,
  clearPicture: () => view.clear(),
  shown: () => view.shown,
  stopPlaying: () => commands.time.stop(),
});
const view: View = new View(model, server, (header, bytes) => {
  server.presented(header, bytes);
  commands.time.presented(header.time);
});
const commands: Commands = new Commands(model, server, view, links);

const root = document.getElementById("app");
if (root !== null) {
  render(
    <PageContext.Provider value={{ model, commands }}>
      <Shell />
    </PageContext.Provider>,
    root,
  );
}
