import { expect, test } from "vitest";
import { forgottenWith, openingDataset } from "../src/model/opening";
import { initialState, type PageState } from "../src/model/state";
import type { DatasetDescription } from "../src/generated/protocol";

const described = (name: string): DatasetDescription => ({ name }) as DatasetDescription;
const shown: PageState = {
  ...initialState,
  scene: { dataset: "old" },
  description: described("old"),
  shownScene: { dataset: "old" },
  lacking: ["p is not written at this time"],
  empty: [{ layer: "iso", why: "outside", reason: "" }],
  missing: ["iso"],
  probe: {
    result: { hit: false, position: null, vertex: null, cell: null, layer: null, patch: null, values: {} },
    time: 0,
  },
};

test("nothing is being opened while the picture is of the scene's dataset", () => {
  expect(openingDataset(shown)).toBeNull();
});

test("a dataset is being opened from the choice until its first picture", () => {
  const chosen = { ...shown, chosen: "new" };
  expect(openingDataset(chosen)).toBe("new");
  const taken = { ...shown, scene: { dataset: "new" } };
  expect(openingDataset(taken)).toBe("new");
  expect(openingDataset({ ...taken, shownScene: { dataset: "new" } })).toBeNull();
});

test("it is no longer being opened when the server has said why it cannot be drawn", () => {
  const taken = { ...shown, scene: { dataset: "new" } };
  expect(openingDataset({ ...taken, failedRevision: 4 })).toBeNull();
  expect(openingDataset({ ...taken, fatal: "There is no dataset 'new'" })).toBeNull();
});

test("what was said of a dataset goes with it", () => {
  const kept = forgottenWith(shown, { dataset: "old", time: 3 });
  expect(kept).toEqual({});
  const gone = { ...shown, ...forgottenWith(shown, { dataset: "new" }) };
  expect(gone).toMatchObject({ description: null, probe: null, lacking: [], empty: [], missing: [] });
  const upcoming = { ...shown, upcoming: described("new") };
  expect(forgottenWith(upcoming, { dataset: "new" }).description?.name).toBe("new");
  expect(forgottenWith(upcoming, { dataset: "other" }).description).toBeNull();
});
