import { describe, expect, test } from "vitest";
import { Latency } from "../src/server/latency";

describe("latency", () => {
  test("from the hand's move to its picture", () => {
    const latency = new Latency();
    latency.accepted(2, 1000);
    latency.shown(1, 1010); // a picture of the previous revision
    expect(latency.last).toBeNull();
    latency.shown(2, 1035);
    expect(latency.last).toBe(35);
  });

  test("a picture of later changes answers the newest of them", () => {
    const latency = new Latency();
    latency.accepted(2, 1000);
    latency.accepted(3, 1020);
    latency.shown(3, 1050);
    expect(latency.last).toBe(30);
  });

  test("the picture may come before the answer, and the still counts for nothing", () => {
    const latency = new Latency();
    latency.shown(2, 1040);
    latency.accepted(2, 1000);
    expect(latency.last).toBe(40);
    latency.shown(2, 1500);
    expect(latency.last).toBe(40);
  });

  test("another session's revisions are another count", () => {
    const latency = new Latency();
    latency.shown(50, 1000);
    latency.reset();
    latency.accepted(2, 2000);
    expect(latency.last).toBeNull();
    latency.shown(2, 2020);
    expect(latency.last).toBe(20);
  });

  test("pictures per second, and none when nothing moves", () => {
    const latency = new Latency();
    for (let at = 0; at <= 1000; at += 50) latency.shown(at, at);
    expect(latency.framesPerSecond(1000)).toBeCloseTo(20, 6);
    expect(latency.framesPerSecond(5000)).toBe(0);
  });
});
