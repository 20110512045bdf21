// Dependencies of all commands: model, server, canvases and messages to the user.
import type { Model } from "../model/model";
import type { Server } from "../server/server";
import type { View } from "../view/view";

export interface Deps {
  readonly model: Model;
  readonly server: Server;
  readonly view: View;
  tell(text: string, kind?: "error" | "info"): void;
  /** Tells the user that a call failed. `failed` is the start of the message if the connection was lost. */
  unanswered(error: unknown, failed: string): void;
}
