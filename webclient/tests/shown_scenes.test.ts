import { expect, test } from "vitest";
import type { Scene } from "../src/generated/protocol";
import { ShownScenes } from "../src/model/shown_scenes";

const seenFrom = (x: number | null, dataset = "a"): Scene => ({
  dataset,
  camera: x === null ? null : { position: [x, 0, 0], target: [0, 0, 0] },
});

test("a picture's camera is that of its revision, however far the hand has turned since", () => {
  const scenes = new ShownScenes();
  expect(scenes.cameraOf(5)).toBeNull();
  for (const revision of [3, 4, 7]) scenes.taken(revision, seenFrom(revision));
  expect(scenes.cameraOf(2)).toBeNull();
  expect(scenes.cameraOf(4)?.position).toEqual([4, 0, 0]);
  expect(scenes.cameraOf(6)?.position).toEqual([4, 0, 0]); // revisions 5 and 6 have the camera of 4
  expect(scenes.cameraOf(7)?.position).toEqual([7, 0, 0]);
  scenes.taken(7, seenFrom(8)); // the same revision with another scene replaces it
  expect(scenes.cameraOf(9)?.position).toEqual([8, 0, 0]);
  scenes.taken(9, seenFrom(null));
  expect(scenes.cameraOf(9)).toBeNull();
  scenes.taken(10, seenFrom(1));
  scenes.clear();
  expect(scenes.cameraOf(10)).toBeNull();
});

test("a picture is of the dataset of its revision", () => {
  const scenes = new ShownScenes();
  scenes.taken(1, seenFrom(0, "a"));
  scenes.taken(4, seenFrom(0, "b"));
  expect(scenes.of(3)?.dataset).toBe("a");
  expect(scenes.of(4)?.dataset).toBe("b");
});
