import { expect, test } from "vitest";
import { families, inverted, searched, withAll, withNone, withoutPrefix, type Patch } from "../src/model/patches";

const patches = (...names: string[]): Patch[] => names.map((name) => ({ name, facts: "", count: 1 }));
const bike = patches("inlet", "lower_wall", "motorBike_frame:016%16", "motorBike_seat%24", "outlet", "motorBike_rim%3");
const names = (list: readonly Patch[]): string[] => list.map(({ name }) => name);

test("patches that begin alike are one family, in the order of the first; others stand alone", () => {
  expect(families(bike).map(({ prefix, patches: of }) => [prefix, of.length])).toEqual([
    ["", 1],
    ["", 1],
    ["motorBike", 3],
    ["", 1],
  ]);
  expect(families(patches("a_", "a_b", "a"))).toHaveLength(3); // "a_" is no prefix: nothing follows the separator
  const [found] = families(searched(bike, "seat"), bike);
  expect([found?.prefix, found?.patches.length]).toEqual(["motorBike", 1]); // same family as without the search
  expect(withoutPrefix("motorBike_seat%24", "motorBike")).toBe("seat%24");
  expect(withoutPrefix("inlet", "")).toBe("inlet");
});

test("a search finds all its words in any order and case", () => {
  expect(names(searched(bike, " BIKE seat "))).toEqual(["motorBike_seat%24"]);
  expect(searched(bike, "")).toHaveLength(6);
  expect(searched(bike, "wheel")).toEqual([]);
});

test("all of them are the whole boundary, all that are found are added to what is shown", () => {
  expect(withAll(bike, ["inlet"], bike)).toEqual([]);
  expect(withAll(bike, ["outlet"], searched(bike, "rim"))).toEqual(["outlet", "motorBike_rim%3"]);
  expect(withAll(bike, null, searched(bike, "inlet"))).toEqual(["inlet"]);
});

test("none of them is nothing, none that are found leaves the others", () => {
  expect(withNone(bike, ["inlet"], bike)).toBeNull();
  expect(withNone(bike, [], searched(bike, "motor"))).toEqual(["inlet", "lower_wall", "outlet"]);
  expect(withNone(bike, ["inlet", "outlet"], searched(bike, "outlet"))).toEqual(["inlet"]);
});

test("inverting twice gives back what was shown", () => {
  expect(inverted(bike, ["inlet", "outlet"], bike)).toEqual(names(bike).filter((name) => !name.endsWith("let")));
  expect(inverted(bike, [], bike)).toBeNull();
  expect(inverted(bike, null, bike)).toEqual([]);
  for (const shown of [["inlet"], null, []]) expect(inverted(bike, inverted(bike, shown, bike), bike)).toEqual(shown);
});
