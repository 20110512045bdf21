import { describe, expect, test } from "vitest";
import { chooseStream, type StreamFacts } from "../src/server/choose_stream";
import { DrawPace } from "../src/server/draw_pace";

const MBIT = 1e6 / 8;

/** The demo dataset's surface over a connection of 10 Mbit/s, drawn by a graphics card. */
const facts: StreamFacts = {
  current: "image",
  gesture: "rest",
  lineRate: 10 * MBIT,
  sawStill: true,
  roundTripMs: 200,
  pictureBytes: 40_000,
  pictureMs: 60,
  polygonBytes: 1_800_000,
  changeBytes: 1_800_000,
  extractMs: 20,
  drawMs: null,
  hardware: true,
  onlyPictures: "",
};
const chosen = (change: Partial<StreamFacts>): string => chooseStream({ ...facts, ...change }).stream;

describe("the automatic stream", () => {
  test.each([
    { what: "a value over a slow line", change: { gesture: "value" }, stream: "image" },
    { what: "a value on a fast line", change: { gesture: "value", lineRate: 1000 * MBIT }, stream: "geometry" },
    { what: "a value of few polygons", change: { gesture: "value", polygonBytes: 30_000 }, stream: "geometry" },
    {
      what: "a value of few polygons, large pictures",
      change: { gesture: "value", polygonBytes: 90_000, pictureBytes: 300_000 },
      stream: "geometry",
    },
    {
      what: "a near server whose frames were too short to measure",
      change: { lineRate: null, roundTripMs: 2 },
      stream: "geometry",
    },
    {
      what: "a near server whose first still measures the line",
      change: { lineRate: null, roundTripMs: 2, sawStill: false },
      stream: "image",
    },
    {
      what: "polygons of fewer bytes than a picture on any line",
      change: { lineRate: null, polygonBytes: 30_000 },
      stream: "geometry",
    },
    {
      what: "few polygons before a still has come",
      change: { lineRate: null, polygonBytes: 0, sawStill: false },
      stream: "image",
    },
    { what: "a far server whose frames were too short to measure", change: { lineRate: null }, stream: "image" },
    { what: "the camera, polygons are here", change: { gesture: "camera", current: "geometry" }, stream: "geometry" },
    { what: "the camera, polygons would keep it waiting", change: { gesture: "camera" }, stream: "image" },
    {
      what: "the camera, polygons come at once",
      change: { gesture: "camera", lineRate: 100 * MBIT },
      stream: "geometry",
    },
    { what: "a pause in which they come", change: {}, stream: "geometry" },
    {
      what: "a value whose change is small, all is here",
      change: { gesture: "value", current: "geometry", changeBytes: 400 },
      stream: "geometry",
    },
    {
      what: "a value whose change is small, all would come first",
      change: { gesture: "value", changeBytes: 400 },
      stream: "image",
    },
    { what: "a pause that is too short for them", change: { polygonBytes: 50_000_000 }, stream: "image" },
    { what: "a browser without a graphics card", change: { hardware: false, polygonBytes: 10 }, stream: "image" },
    {
      what: "a browser that draws too slowly",
      change: { current: "geometry", gesture: "camera", drawMs: 400 },
      stream: "image",
    },
    {
      what: "a slow browser on a line that is slower",
      change: { current: "geometry", gesture: "camera", drawMs: 400, pictureBytes: 800_000 },
      stream: "geometry",
    },
    { what: "a volume", change: { current: "geometry", onlyPictures: "a volume" }, stream: "image" },
    { what: "a line that is not measured", change: { lineRate: null }, stream: "image" },
  ] as { what: string; change: Partial<StreamFacts>; stream: string }[])("$what: $stream", ({ change, stream }) => {
    expect(chosen(change)).toBe(stream);
  });

  test("a scene at the border does not flip", () => {
    const border = { gesture: "value", polygonBytes: 60_000, changeBytes: 60_000, pictureMs: 66 } as const;
    expect(chosen({ ...border, current: "image" })).toBe("image");
    expect(chosen({ ...border, current: "geometry" })).toBe("geometry");
  });

  test.each([
    {
      change: { gesture: "value" as const },
      why: "a change takes 1.5 s with polygons (1.8 MB at 1.3 MB/s) and 0.06 s with pictures",
    },
    { change: {}, why: "the polygons (1.8 MB) arrive in 1.4 s at 1.3 MB/s" },
    { change: { lineRate: null, polygonBytes: 900 }, why: "the polygons are 0.9 kB, a picture is 40 kB" },
    { change: { hardware: false }, why: "without a graphics card" },
    { change: { drawMs: 400 }, why: "needs 0.40 s to draw the polygons, a picture arrives in 0.06 s" },
    { change: { onlyPictures: "a volume" }, why: "a volume is shown in pictures only" },
  ])("says why: $why", ({ change, why }) => {
    expect(chooseStream({ ...facts, ...change }).why).toContain(why);
  });
});

describe("the browser's pace", () => {
  const after = (...waits: number[]): number | null => {
    const pace = new DrawPace();
    waits.forEach((wait, i) => pace.drawn(1000 * i, 1000 * i + wait));
    return pace.milliseconds;
  };

  test("is not known by the first drawings, which compile programs", () => {
    expect(after(900, 16, 16)).toBeNull();
    expect(after(900, 16, 16, 16)).toBe(16);
  });

  test("of another dataset is forgotten", () => {
    const pace = new DrawPace();
    for (let i = 0; i < 6; i += 1) pace.drawn(1000 * i, 1000 * i + 300);
    expect(pace.milliseconds).toBe(300);
    pace.forget();
    expect(pace.milliseconds).toBeNull();
  });

  test("is that of the wish, not of a hand that moves now and then", () => {
    expect(after(...Array.from({ length: 20 }, () => 12))).toBe(12);
  });

  test("a browser that draws in software is seen", () => {
    expect(after(170, 165, 180, 170, 175)).toBeGreaterThan(100);
  });
});
