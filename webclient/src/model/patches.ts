// Patches of the boundary. Finds which patches a layer shows, and groups and searches a long list of patches.
import type { DatasetDescription } from "../generated/protocol";

export interface Patch {
  name: string;
  /** Number of boundary faces in the patch. */
  count: number;
  /** The solver's patch type and boundary conditions, one per line. Empty if unknown. */
  facts: string;
}

export interface PatchFamily {
  /** Common prefix of the patches' names; empty for a single patch. */
  prefix: string;
  patches: Patch[];
}

/** Names of the patches that a layer shows. []: the whole boundary; null: nothing. */
export type Shown = readonly string[] | null;

const factsOf = ({ type, conditions }: DatasetDescription["groups"][number]): string => {
  const each = Object.entries(conditions ?? {}).map(([array, condition]) => `${array}: ${condition}`);
  return [...(type === undefined ? [] : [type]), ...each].join("\n");
};

export const patchesOf = (description: DatasetDescription | null): Patch[] =>
  (description?.groups ?? [])
    .filter(({ of }) => of === "faces")
    .map((group) => ({ name: group.name, count: group.count, facts: factsOf(group) }));

const prefixOf = (name: string): string => /^[^_.:/\s]+(?=[_.:/\s].)/.exec(name)?.[0] ?? "";

export const withoutPrefix = (name: string, prefix: string): string =>
  prefix === "" ? name : name.slice(prefix.length + 1);

/** Groups patches by name prefix. A patch is alone in its family if no other patch of `among` has the same prefix. */
export function families(patches: readonly Patch[], among = patches): PatchFamily[] {
  const found = new Map<string, PatchFamily>();
  const sharing = new Map<string, number>();
  for (const { name } of among) sharing.set(prefixOf(name), (sharing.get(prefixOf(name)) ?? 0) + 1);
  for (const patch of patches) {
    const prefix = (sharing.get(prefixOf(patch.name)) ?? 0) > 1 ? prefixOf(patch.name) : "";
    const key = prefix === "" ? `alone ${patch.name}` : `family ${prefix}`;
    const family = found.get(key) ?? { prefix, patches: [] };
    family.patches.push(patch);
    found.set(key, family);
  }
  return [...found.values()];
}

export function searched(patches: readonly Patch[], text: string): Patch[] {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  return patches.filter(({ name }) => words.every((word) => name.toLowerCase().includes(word)));
}

const namesOf = (shown: Shown): readonly string[] => shown ?? [];

/** Returns the names in the dataset's order, so that equal choices give equal scenes. */
function inOrder(all: readonly Patch[], names: ReadonlySet<string>): Shown {
  const chosen = all.filter(({ name }) => names.has(name)).map(({ name }) => name);
  return chosen.length === 0 ? null : chosen;
}

export function withAll(all: readonly Patch[], shown: Shown, these: readonly Patch[]): Shown {
  if (these.length === all.length) return []; // [] is the whole boundary, which may have faces in no patch
  return inOrder(all, new Set([...namesOf(shown), ...these.map(({ name }) => name)]));
}

export function withNone(all: readonly Patch[], shown: Shown, these: readonly Patch[]): Shown {
  const before = shown !== null && shown.length === 0 ? all.map(({ name }) => name) : namesOf(shown);
  const gone = new Set(these.map(({ name }) => name));
  return inOrder(all, new Set(before.filter((name) => !gone.has(name))));
}

export function inverted(all: readonly Patch[], shown: Shown, these: readonly Patch[]): Shown {
  const before = new Set(shown !== null && shown.length === 0 ? all.map(({ name }) => name) : namesOf(shown));
  for (const { name } of these) if (!before.delete(name)) before.add(name);
  return before.size === all.length ? [] : inOrder(all, before);
}
