// What a server says of a session in which nothing has been done.
import type { Scene, SessionState } from "../src/generated/protocol";

export const state = (scene: Scene, revision = 1): SessionState => ({
  session: "s",
  revision,
  scene,
  can_undo: false,
  can_redo: false,
});
