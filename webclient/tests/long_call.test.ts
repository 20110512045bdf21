import { describe, expect, test } from "vitest";
import { wordsOf } from "../src/model/long_call";

const call = { words: "Drawing the picture", name: "1" };
const at = (
  stage: "reading" | "surfaces" | "measuring" | "waiting" | "drawing" | "writing",
  done = 0,
  of = 0,
): string => wordsOf({ ...call, progress: { progress: "1", stage, done, of } });

describe("words of a long call", () => {
  test("before the server has begun it", () =>
    expect(wordsOf({ ...call, progress: null })).toBe("Drawing the picture"));
  test("of a stage", () => {
    expect(at("reading")).toBe("Drawing the picture: reading the step from its source");
    expect(at("measuring", 5, 10)).toBe("Drawing the picture: measuring");
    expect(at("waiting")).toBe("Drawing the picture: waiting for another picture");
    expect(at("drawing")).toBe("Drawing the picture: drawing");
    expect(at("writing")).toBe("Drawing the picture: writing the file");
  });
  test("of one layer, which is not counted", () =>
    expect(at("surfaces", 0, 1)).toBe("Drawing the picture: computing the layers"));
  test("of several layers, each by its number", () => {
    expect(at("surfaces", 0, 4)).toBe("Drawing the picture: layer 1 of 4");
    expect(at("surfaces", 3, 4)).toBe("Drawing the picture: layer 4 of 4");
    expect(at("surfaces", 4, 4)).toBe("Drawing the picture: layer 4 of 4");
  });
});
