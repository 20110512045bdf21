// JSON Merge Patch (RFC 7396), and two operations that RFC 7396 does not define: composition and difference.

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonObject = { [key: string]: Json };

export function isObject(value: unknown): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export function applyPatch(document: Json | undefined, patch: Json): Json {
  if (!isObject(patch)) return patch;
  const before = isObject(document) ? document : {};
  const kept = Object.entries(before).filter(([key]) => !(key in patch));
  const set = Object.entries(patch).filter(([, value]) => value !== null);
  return Object.fromEntries([...kept, ...set.map(([key, value]) => [key, applyPatch(before[key], value)] as const)]);
}

/**
 * Returns one patch with the effect of `first` and then `second`; null if there is none. RFC 7396 merges objects. So
 * there is none if `second` sets an object where `first` removes a member or sets a value that is not an object.
 */
export function composePatches(first: JsonObject, second: JsonObject): JsonObject | null {
  const result: JsonObject = { ...first };
  for (const [key, value] of Object.entries(second)) {
    const before = result[key];
    if (before === undefined || !isObject(value)) {
      result[key] = value;
      continue;
    }
    const both = isObject(before) ? composePatches(before, value) : null;
    if (both === null) return null;
    result[key] = both;
  }
  return result;
}

/** Returns the patch that turns `from` into `to`. RFC 7396 cannot express members that are null in `to`. */
export function diff(from: JsonObject, to: JsonObject): JsonObject {
  const patch: JsonObject = {};
  for (const key of Object.keys(from)) if (!(key in to)) patch[key] = null;
  for (const [key, value] of Object.entries(to)) {
    const before = from[key];
    if (equal(before, value)) continue;
    patch[key] = isObject(before) && isObject(value) ? diff(before, value) : value;
  }
  return patch;
}

/**
 * Returns a value equal to `after`. Objects and arrays that equal those at the same place in `before` are taken from
 * `before`. A computed signal of such an object then does not change.
 */
export function keepEqual(before: Json | undefined, after: Json): Json {
  if (Array.isArray(before) && Array.isArray(after)) {
    const items = after.map((value, index) => keepEqual(before[index], value));
    return items.length === before.length && items.every((item, index) => item === before[index]) ? before : items;
  }
  if (!isObject(before) || !isObject(after)) return after;
  const members = Object.entries(after).map(([key, value]) => [key, keepEqual(before[key], value)] as const);
  const isSame =
    members.length === Object.keys(before).length && members.every(([key, value]) => value === before[key]);
  return isSame ? before : Object.fromEntries(members);
}

export function equal(a: Json | undefined, b: Json | undefined): boolean {
  if (a === b) return true;
  if (Array.isArray(a) && Array.isArray(b)) {
    return a.length === b.length && a.every((value, index) => equal(value, b[index]));
  }
  if (!isObject(a) || !isObject(b)) return false;
  const keys = Object.keys(a);
  return keys.length === Object.keys(b).length && keys.every((key) => key in b && equal(a[key], b[key]));
}
