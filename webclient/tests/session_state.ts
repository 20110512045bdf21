// The server's answer when a session was just opened.
import type { Scene, SessionState } from "../src/generated/protocol";

export const state = (scene: Scene, revision = 1): SessionState => ({
  session: "s",
  revision,
  scene,
  can_undo: false,
  can_redo: false,
});
