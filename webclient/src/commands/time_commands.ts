import { clamp } from "../model/numbers";
import { nearestStep } from "../model/scalars";
import type { Deps } from "./deps";
import { Player } from "./player";

export class TimeCommands {
  private readonly player: Player;

  constructor(private readonly deps: Deps) {
    const { model, server } = deps;
    this.player = new Player(
      {
        times: () => this.times(),
        shownStep: () => nearestStep(this.times(), model.scene.peek()?.time),
        show: (step, gesture) => {
          const time = this.times()[step];
          if (time !== undefined) server.editor.changeAutomatically({ time }, gesture);
        },
        newGesture: () => server.editor.newGesture(),
        rate: () => model.playRate.peek(),
        loop: () => model.loop.peek(),
        playing: model.playing,
      },
      () => performance.now(),
    );
  }

  setStep(step: number, gesture?: string): void {
    const time = this.times()[clamp(step, 0, this.times().length - 1)];
    if (time !== undefined) this.deps.server.editor.change({ time }, gesture);
  }

  stepBy(steps: number): void {
    this.player.stop();
    this.setStep(nearestStep(this.times(), this.deps.model.scene.peek()?.time) + steps);
  }

  togglePlay(): void {
    if (this.deps.model.playing.peek()) this.player.stop();
    else this.player.play();
  }

  stop(): void {
    this.player.stop();
  }

  presented(time: number): void {
    this.player.presented(time);
  }

  setLoop(loop: boolean): void {
    this.deps.model.loop.value = loop;
  }

  /** `rate`: time steps per second. */
  setRate(rate: number): void {
    this.deps.model.playRate.value = rate;
  }

  private times(): readonly number[] {
    return this.deps.model.description.peek()?.times ?? [];
  }
}
