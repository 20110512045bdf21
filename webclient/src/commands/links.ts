// Writes the scene into the page's address, and opens the scene of a link that the user follows.
import type { Scene } from "../generated/protocol";
import { decodeScene, decodeSession, encodeScene, encodeSession } from "../model/link";
import { equal, type Json } from "../model/merge_patch";
import type { Model } from "../model/model";
import type { Server } from "../server/server";

const PAUSE_MS = 400;

export class Links {
  private timer: ReturnType<typeof setTimeout> | null = null;
  /** Scene in the address with which the page was opened; null if the address contained no scene. */
  first: Scene | null = null;
  private written = "";

  constructor(
    private readonly model: Model,
    private readonly server: () => Server,
  ) {}

  async start(): Promise<void> {
    this.first = await this.decoded();
    window.addEventListener("hashchange", () => void this.follow());
  }

  async address(): Promise<string> {
    const scene = this.model.scene.peek();
    const url = new URL(location.href);
    if (scene !== null) url.hash = await encodeScene(scene);
    return url.href;
  }

  sessionAddress(): string {
    const url = new URL(location.href);
    url.hash = encodeSession(this.server().tab.id);
    return url.href;
  }

  private async follow(): Promise<void> {
    if (location.hash === this.written) return;
    if (decodeSession(location.hash) !== null) {
      location.reload(); // a page can use only one session: the session of the link needs a new page load
      return;
    }
    const scene = await this.decoded();
    if (scene === null) return;
    // The scene of a link may be invalid. Therefore the local scene changes only after the server has accepted it.
    const { editor, session } = this.server();
    if (this.model.fatal.peek() === null) await editor.propose(scene);
    else await session.begin(scene);
  }

  /** Writes the scene into the address when it has not changed for a while. */
  writeSoon(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.write(), PAUSE_MS);
  }

  private async write(): Promise<void> {
    const scene = this.model.scene.peek();
    if (scene === null) return;
    const fragment = await encodeScene(scene);
    if (!equal(scene as unknown as Json, this.model.scene.peek() as unknown as Json)) return; // the scene has changed
    this.written = fragment;
    history.replaceState(null, "", fragment);
  }

  private async decoded(): Promise<Scene | null> {
    try {
      return await decodeScene(location.hash);
    } catch (error) {
      this.server().fail(error);
      return null;
    }
  }
}
