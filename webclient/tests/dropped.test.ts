import { expect, test } from "vitest";
import { answerToDrop } from "../src/commands/dropped";

test("a dropped file is answered with what to do", () => {
  expect(answerToDrop("wing.vtu")).toContain("ciel import wing.vtu -o wing.ciel");
  expect(answerToDrop("case.01.foam")).toContain("-o case.01.ciel");
  expect(answerToDrop(".hidden")).toContain("-o .hidden.ciel");
  expect(answerToDrop("box.ciel")).toContain("ciel serve box.ciel");
});
