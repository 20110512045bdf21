import { render } from "preact";
import { App } from "./app/app";
import { AppContext } from "./panels/context";
import { Shell } from "./panels/shell";
import { hideToken } from "./session/browser_socket";
import "./style/tokens.css";
import "./style/layout.css";
import "./style/controls.css";
import "./style/panels.css";
import "./style/annotations.css";
import "./style/overlays.css";
import "./style/colors.css";

hideToken();
const root = document.getElementById("app");
if (root !== null) {
  render(
    <AppContext.Provider value={new App()}>
      <Shell />
    </AppContext.Provider>,
    root,
  );
}
