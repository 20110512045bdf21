import { expect, test } from "vitest";
import type { Scene } from "../src/generated/protocol";
import { makeModel } from "../src/model/model";
import { ShownScenes } from "../src/model/shown_scenes";
import { emptyReadout } from "../src/model/state";

const seenFrom = (x: number | null, dataset = "a"): Scene => ({
  dataset,
  camera: x === null ? null : { position: [x, 0, 0], target: [0, 0, 0] },
});

test("a picture's scene is that of its revision, however far the hand has turned since", () => {
  const scenes = new ShownScenes();
  const cameraOf = (revision: number): number | undefined => scenes.of(revision)?.camera?.position[0];
  expect(scenes.of(5)).toBeNull();
  for (const revision of [3, 4, 7]) scenes.taken(revision, seenFrom(revision));
  expect(scenes.of(2)).toBeNull();
  expect(cameraOf(4)).toBe(4);
  expect(cameraOf(6)).toBe(4); // revisions 5 and 6 have the camera of 4
  expect(cameraOf(7)).toBe(7);
  scenes.taken(7, seenFrom(8)); // the same revision with another scene replaces it
  expect(cameraOf(9)).toBe(8);
  scenes.taken(10, seenFrom(1));
  scenes.clear();
  expect(scenes.of(10)).toBeNull();
});

test("a picture is of the dataset of its revision", () => {
  const scenes = new ShownScenes();
  scenes.taken(1, seenFrom(0, "a"));
  scenes.taken(4, seenFrom(0, "b"));
  expect(scenes.of(3)?.dataset).toBe("a");
  expect(scenes.of(4)?.dataset).toBe("b");
});

test("a picture is seen from its scene's camera, polygons from the newest", () => {
  const model = makeModel({ shownScene: seenFrom(4), readout: { ...emptyReadout, stream: "image" } });
  expect(model.shownFrom.value?.position).toEqual([4, 0, 0]);
  const first = model.shownFrom.value;
  model.readout.value = { ...model.readout.value, framesPerSecond: 9 };
  expect(model.shownFrom.value).toBe(first);
  model.shownScene.value = seenFrom(null);
  expect(model.shownFrom.value).toBeNull();
  model.shownScene.value = seenFrom(5);
  model.readout.value = { ...model.readout.value, stream: "geometry" };
  expect(model.shownFrom.value).toBeNull();
});
