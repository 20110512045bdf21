// Plays the time steps. Requests each step only after the previous step is on the screen.
import type { Signal } from "@preact/signals";

export interface PlayerHost {
  times(): readonly number[];
  shownStep(): number;
  show(step: number, gesture: string): void;
  newGesture(): string;
  rate(): number; // largest number of steps per second
  loop(): boolean;
  readonly playing: Signal<boolean>;
}

export class Player {
  private gesture = "";
  private timer: ReturnType<typeof setTimeout> | null = null;
  private wanted: number | null = null;
  private askedAt = 0;

  constructor(
    private readonly host: PlayerHost,
    private readonly now: () => number,
  ) {}

  play(): void {
    if (this.host.playing.peek() || this.host.times().length < 2) return;
    this.gesture = this.host.newGesture();
    this.host.playing.value = true;
    if (!this.host.loop() && this.host.shownStep() === this.host.times().length - 1) this.ask(0);
    else this.advance();
  }

  stop(): void {
    if (!this.host.playing.peek()) return;
    this.wanted = null;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    this.host.playing.value = false;
  }

  /** Call when a frame of this simulation time has been drawn on the screen. */
  presented(time: number): void {
    if (this.wanted === null || this.host.times()[this.wanted] !== time) return;
    this.wanted = null;
    const left = 1000 / this.host.rate() - (this.now() - this.askedAt);
    this.timer = setTimeout(() => this.advance(), Math.max(0, left));
  }

  private advance(): void {
    this.timer = null;
    if (!this.host.playing.peek()) return;
    const next = this.host.shownStep() + 1;
    const count = this.host.times().length;
    if (next < count) this.ask(next);
    else if (this.host.loop()) this.ask(0);
    else this.stop();
  }

  private ask(step: number): void {
    this.wanted = step;
    this.askedAt = this.now();
    this.host.show(step, this.gesture);
  }
}
