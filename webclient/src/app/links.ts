// The address bar always holds the scene, and a link that is followed becomes the scene.
import type { Scene } from "../generated/protocol";
import { equal, type Json } from "../protocol/merge_patch";
import { decodeScene, decodeSession, encodeScene, encodeSession } from "../scene/link";
import type { App } from "./app";

const PAUSE_MS = 400;

export class Links {
  private timer: ReturnType<typeof setTimeout> | null = null;
  /** What the address held when the page was opened. */
  first: Scene | null = null;
  private written = "";

  constructor(private readonly app: App) {}

  async readAddress(): Promise<void> {
    this.first = await this.decoded();
  }

  /** After a link was pasted into this page. */
  async follow(): Promise<void> {
    if (location.hash === this.written) return;
    if (decodeSession(location.hash) !== null) {
      location.reload(); // a page has one session for its life
      return;
    }
    const scene = await this.decoded();
    if (scene === null) return;
    // Proposed only: it may be of another server, or made by hand.
    if (this.app.store.get().fatal === null) await this.app.editor.propose(scene);
    else await this.app.session.begin(scene);
  }

  sceneChanged(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.write(), PAUSE_MS);
  }

  async address(): Promise<string> {
    const { scene } = this.app.editor;
    const url = new URL(location.href);
    if (scene !== null) url.hash = await encodeScene(scene);
    return url.href;
  }

  sessionAddress(): string {
    const url = new URL(location.href);
    url.hash = encodeSession(this.app.tab.id);
    return url.href;
  }

  private async write(): Promise<void> {
    const { scene } = this.app.editor;
    if (scene === null) return;
    const fragment = await encodeScene(scene);
    if (!equal(scene as unknown as Json, this.app.editor.scene as unknown as Json)) return; // a newer one follows
    this.written = fragment;
    history.replaceState(null, "", fragment);
  }

  private async decoded(): Promise<Scene | null> {
    try {
      return await decodeScene(location.hash);
    } catch (error) {
      this.app.fail(error);
      return null;
    }
  }
}
