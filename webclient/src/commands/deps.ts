// What commands work with: what the page knows, the server, the canvases, and a way to say something.
import type { Model } from "../model/model";
import type { Server } from "../server/server";
import type { View } from "../view/view";

export interface Deps {
  readonly model: Model;
  readonly server: Server;
  readonly view: View;
  tell(text: string, kind?: "error" | "info"): void;
  /** What a hand asks of the server is not done later by itself, as changes of the scene are. */
  unanswered(error: unknown, failed: string): void;
}
