// Dependencies of all commands: model, server, canvases and messages to the user.
import type { Model } from "../model/model";
import type { Server } from "../server/server";
import type { View } from "../view/view";

export interface Deps {
  readonly model: Model;
  readonly server: Server;
  readonly view: View;
  tell(text: string, kind?: "error" | "info"): void;
  /**
   * Tells the user that a call failed. `failed`: start of the message if the connection was lost. Unlike a change of
   * the scene, a failed call is not repeated after a reconnection.
   */
  unanswered(error: unknown, failed: string): void;
}
