import { expect, test } from "vitest";
import { ShownCameras } from "../src/camera/shown_cameras";

const camera = (x: number) => ({
  position: [x, 0, 0] as [number, number, number],
  target: [0, 0, 0] as [number, number, number],
});

test("a picture's camera is that of its revision, however far the hand has turned since", () => {
  const cameras = new ShownCameras();
  expect(cameras.of(5)).toBeNull();
  for (const revision of [3, 4, 7]) cameras.taken(revision, camera(revision));
  expect(cameras.of(2)).toBeNull();
  expect(cameras.of(4)?.position).toEqual([4, 0, 0]);
  expect(cameras.of(6)?.position).toEqual([4, 0, 0]); // 5 and 6 changed something else
  expect(cameras.of(7)?.position).toEqual([7, 0, 0]);
  cameras.taken(7, camera(8)); // another page of the session tells it, too
  expect(cameras.of(9)?.position).toEqual([8, 0, 0]);
  cameras.taken(9, null);
  expect(cameras.of(9)).toBeNull();
  cameras.taken(10, camera(1));
  cameras.clear();
  expect(cameras.of(10)).toBeNull();
});
