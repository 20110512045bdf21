// Describes an array in words: origin, type, file, missing times, and missing or non-finite values.
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
  return count === 1 ? "1 value is not a number" : `${formatCount(count)} values are not numbers`;
}

export function arrayFacts(array: ArrayInfo, steps: number): string[] {
  const missing = steps - array.times.length;
  return [
    `on ${PLACES[array.association]}`,
    [ORIGINS[array.origin], array.type ?? ""].join(" ").trim(),
    array.type === undefined || array.type === array.stored ? "" : `stored as ${array.stored}`,
    array.file ?? "",
    missing === 0 ? "" : `missing at ${missing} of ${steps} times`,
    array.missing === 0 ? "" : `${formatCount(array.missing)} values are missing`,
    noNumbers(array.invalid),
  ].filter((fact) => fact !== "");
}
