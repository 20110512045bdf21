// Origin of an array's values, and its missing and invalid values, in words.
import type { ArrayInfo } from "../generated/protocol";
import { formatCount } from "./numbers";

const ORIGINS: Record<ArrayInfo["origin"], string> = {
  unknown: "",
  original: "original",
  interpolated: "interpolated from cells",
  derived: "computed by the reader",
};

const PLACES: Record<ArrayInfo["association"], string> = { point: "points", cell: "cells", boundary_face: "patches" };

function noNumbers(count: number): string {
  if (count === 0) return "";
  return count === 1 ? "1 value is no number" : `${formatCount(count)} values are no numbers`;
}

export function arrayFacts(array: ArrayInfo, steps: number): string[] {
  const missing = steps - array.times.length;
  return [
    `on ${PLACES[array.association]}`,
    [ORIGINS[array.origin], array.type ?? ""].join(" ").trim(),
    array.file ?? "",
    missing === 0 ? "" : `missing at ${missing} of ${steps} times`,
    array.missing === 0 ? "" : `${formatCount(array.missing)} values are not there`,
    noNumbers(array.invalid),
  ].filter((fact) => fact !== "");
}
