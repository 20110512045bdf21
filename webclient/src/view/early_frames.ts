// Frames that are here before the answer to view.open, which says whose they are (protocol/frame.md).
import type { FrameHeader } from "../server/frame_header";

/** A server sends no more of a view before the first acknowledgement, and nothing is acknowledged before it is known to be
 * shown. */
const MOST_FRAMES = 2;

interface EarlyFrame {
  frame: number;
  messages: ArrayBuffer[];
}

export class EarlyFrames {
  private readonly views = new Map<number, EarlyFrame[]>();

  keep({ view, frame }: FrameHeader, message: ArrayBuffer): void {
    const frames = this.views.get(view) ?? [];
    this.views.set(view, frames);
    const same = frames.find((other) => other.frame === frame);
    if (same === undefined) frames.push({ frame, messages: [message] });
    else same.messages.push(message);
    if (frames.length > MOST_FRAMES) frames.shift();
  }

  /** In the order in which they came. */
  of(view: number): ArrayBuffer[] {
    return (this.views.get(view) ?? []).flatMap(({ messages }) => messages);
  }
}
