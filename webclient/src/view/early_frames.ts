// Keeps frames that arrive before the answer to view.open, which contains the id of the view (protocol/frame.md).
import type { FrameHeader } from "../generated/frame_header";

/** Frames kept per view. The server sends two frames before the first acknowledgement (limit unacknowledged_frames). */
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

  of(view: number): ArrayBuffer[] {
    return (this.views.get(view) ?? []).flatMap(({ messages }) => messages);
  }
}
