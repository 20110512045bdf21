import { expect, test } from "vitest";
import { emptyReadout, initialState, type PageState } from "../src/model/state";
import { stillDue } from "../src/model/still_due";

const preview: PageState = {
  ...initialState,
  connection: { kind: "open" },
  revision: 7,
  readout: { ...emptyReadout, stream: "image", still: false, revision: 7, frame: 3 },
};

test("after the preview of the newest scene a still is due", () => expect(stillDue(preview)).toBe(true));

test.each<[string, Partial<PageState>]>([
  ["when it is there", { readout: { ...preview.readout, still: true } }],
  ["of polygons", { readout: { ...preview.readout, stream: "geometry" } }],
  ["before there is a picture", { readout: emptyReadout }],
  ["while a change is on its way", { pending: true }],
  ["while the preview is of an older scene", { revision: 8 }],
  ["while time plays", { playing: true }],
  ["without a server", { connection: { kind: "connecting", attempt: 1 } }],
  ["when the server has given up", { failedRevision: 7 }],
])("none is due %s", (_, change) => expect(stillDue({ ...preview, ...change })).toBe(false));
