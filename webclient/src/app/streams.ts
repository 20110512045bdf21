// Which stream the view gets: the person's choice, or for `auto` what the scene and the line suggest.
import { chooseStream, hasHardwareWebGL } from "../session/choose_stream";
import { layersOf } from "../scene/scalars";
import type { App } from "./app";
import { saveStream } from "./preferences";
import type { StreamWish } from "../session/session";
import type { StreamChoice } from "./state";

export class Streams {
  private hardware: boolean | null = null;
  private asked: StreamWish | null = null;

  constructor(private readonly app: App) {}

  /** For a view that is about to be opened. */
  current(): StreamWish {
    this.asked = this.wanted();
    return this.asked;
  }

  choose(choice: StreamChoice): void {
    this.app.store.set({ streamChoice: choice });
    saveStream(choice);
    this.reconsider();
  }

  reconsider(): void {
    const wanted = this.wanted();
    if (wanted.stream === this.asked?.stream && wanted.moving === this.asked.moving) return;
    this.asked = wanted;
    this.app.session.setStream(wanted);
  }

  private wanted(): StreamWish {
    const { streamChoice } = this.app.store.get();
    if (streamChoice === "auto") return { stream: this.suggested(), moving: "jpeg" };
    if (streamChoice === "jpeg") return { stream: "image", moving: "jpeg" };
    return { stream: streamChoice, moving: "png" };
  }

  private suggested(): "image" | "geometry" {
    const { readout, scene } = this.app.store.get();
    if (layersOf(scene, "volume").some(([, layer]) => layer.visible !== false)) return "image"; // no polygons to send
    if (scene?.lighting?.on !== false && scene?.lighting?.ambient_occlusion?.on === true) return "image"; // is not drawn here
    this.hardware ??= hasHardwareWebGL();
    const { triangles, roundTripMs } = readout;
    const current = readout.stream === "geometry" ? "geometry" : "image";
    if (readout.stream === "none") return "image"; // nothing is measured yet
    return chooseStream({ current, triangles, roundTripMs, hardware: this.hardware });
  }
}
