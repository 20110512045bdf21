import { effect, signal } from "@preact/signals";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { Player } from "../src/commands/player";

const times = [0, 0.5, 1];
let shown: number[] = [];
let gestures: string[] = [];
let plays = 0;
let playing = signal(false);
let states: boolean[] = [];
let loop = true;
let step = 0;
let player: Player;

beforeEach(() => {
  vi.useFakeTimers();
  [shown, gestures, states, loop, step, plays] = [[], [], [], true, 0, 0];
  playing = signal(false);
  effect(() => void states.push(playing.value));
  player = new Player(
    {
      times: () => times,
      shownStep: () => step,
      show: (next, gesture) => {
        step = next;
        shown.push(next);
        gestures.push(gesture);
      },
      newGesture: () => `g${++plays}`,
      rate: () => 10,
      loop: () => loop,
      playing,
    },
    () => performance.now(),
  );
});
afterEach(() => void vi.useRealTimers());

const present = (): void => {
  player.presented(times[step] ?? NaN);
  vi.advanceTimersByTime(100);
};

describe("player", () => {
  test("asks for the next step when the last one has been seen, not before", () => {
    player.play();
    expect(shown).toEqual([1]);
    vi.advanceTimersByTime(10_000); // no picture arrives in this time
    expect(shown).toEqual([1]);
    player.presented(0); // picture of the time before
    vi.advanceTimersByTime(1000);
    expect(shown).toEqual([1]);
    present();
    expect(shown).toEqual([1, 2]);
  });

  test("no faster than the rate", () => {
    player.play();
    player.presented(0.5);
    vi.advanceTimersByTime(99);
    expect(shown).toEqual([1]);
    vi.advanceTimersByTime(1);
    expect(shown).toEqual([1, 2]);
  });

  test("loops, as one gesture", () => {
    player.play();
    for (let i = 0; i < 4; i += 1) present();
    expect(shown).toEqual([1, 2, 0, 1, 2]);
    expect(new Set(gestures).size).toBe(1);
  });

  test("without the loop it ends at the last step and starts again from the first", () => {
    loop = false;
    player.play();
    present();
    present();
    expect(states).toEqual([false, true, false]);
    player.play();
    expect(shown).toEqual([1, 2, 0]);
  });

  test("stopped, a late picture moves nothing", () => {
    player.play();
    player.stop();
    present();
    expect(shown).toEqual([1]);
    expect(states).toEqual([false, true, false]);
  });
});
