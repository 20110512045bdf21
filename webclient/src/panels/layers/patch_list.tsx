// Chooses which part of the boundary a layer shows: the whole boundary, or patches from a searchable list.
import type { JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { formatCount } from "../../model/numbers";
import {
  families,
  inverted,
  patchesOf,
  searched,
  withAll,
  withNone,
  withoutPrefix,
  type Patch,
  type PatchFamily,
} from "../../model/patches";
import { Check } from "../controls/controls";
import { useModel } from "../context";
import { Icon } from "../controls/icons";

interface Props {
  /** Names of the shown patches. Empty: the whole boundary is shown. */
  groups: readonly string[];
  /** False if the layer is hidden. No patch is ticked then. */
  shown?: boolean;
  /** Called with the names of all ticked patches. null: no patch is ticked. */
  onChange: (groups: string[] | null) => void;
}

/** The patches of a list up to this length are all visible at once and need no search field. */
const WORTH_A_SEARCH = 8;

interface RowProps {
  patch: Patch;
  prefix: string;
  checked: boolean;
  toggle: (name: string, on: boolean) => void;
  only: (patches: readonly Patch[]) => void;
}

function PatchRow({ patch, prefix, checked, toggle, only }: RowProps): JSX.Element {
  const { name, count, facts } = patch;
  return (
    <li class="patch-row">
      <label class="check" title={facts === "" ? name : `${name}\n${facts}`}>
        <input
          type="checkbox"
          aria-label={name}
          checked={checked}
          onChange={(event) => toggle(name, event.currentTarget.checked)}
        />
        <span>{withoutPrefix(name, prefix)}</span>
        <small>{`${facts.split("\n")[0] ?? ""} ${formatCount(count)} faces`.trim()}</small>
      </label>
      <button type="button" class="button small" aria-label={`Only ${name}`} onClick={() => only([patch])}>
        Only
      </button>
    </li>
  );
}

interface FamilyProps {
  family: PatchFamily;
  isOpen: boolean;
  fold: () => void;
  ticked: ReadonlySet<string>;
  toggle: (name: string, on: boolean) => void;
  toggleAll: (patches: readonly Patch[], on: boolean) => void;
  only: (patches: readonly Patch[]) => void;
}

function Family({ family, isOpen, fold, ticked, toggle, toggleAll, only }: FamilyProps): JSX.Element {
  const { prefix, patches } = family;
  const count = patches.filter(({ name }) => ticked.has(name)).length;
  const box = useRef<HTMLInputElement>(null);
  const isMixed = count > 0 && count < patches.length;
  useEffect(() => {
    if (box.current !== null) box.current.indeterminate = isMixed;
  }, [isMixed]);
  return (
    <li>
      <div class="patch-row family">
        <button type="button" class="fold" aria-expanded={isOpen} aria-label={`Patches of ${prefix}`} onClick={fold}>
          <Icon name="chevron" />
        </button>
        <label class="check">
          <input
            type="checkbox"
            ref={box}
            aria-label={`All of ${prefix}`}
            checked={count === patches.length}
            onChange={(event) => toggleAll(patches, event.currentTarget.checked)}
          />
          <span>{`${prefix} (${patches.length})`}</span>
          {isMixed && <small>{`${count} shown`}</small>}
        </label>
        <button type="button" class="button small" aria-label={`Only all of ${prefix}`} onClick={() => only(patches)}>
          Only
        </button>
      </div>
      {isOpen && (
        <ul>
          {patches.map((patch) => (
            <PatchRow
              key={patch.name}
              patch={patch}
              prefix={prefix}
              checked={ticked.has(patch.name)}
              toggle={toggle}
              only={only}
            />
          ))}
        </ul>
      )}
    </li>
  );
}

interface ToolsProps {
  search: string;
  setSearch: (text: string) => void;
  hasSearch: boolean;
  apply: (change: typeof withAll) => void;
}

function Tools({ search, setSearch, hasSearch, apply }: ToolsProps): JSX.Element {
  return (
    <div class="patch-tools">
      {hasSearch && (
        <input
          type="text"
          class="text-field"
          role="searchbox"
          aria-label="Search patches"
          placeholder="Search patches"
          value={search}
          onInput={(event) => setSearch(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key !== "Escape" || search === "") return;
            event.stopPropagation();
            setSearch("");
          }}
        />
      )}
      <div class="row" role="group" aria-label={search === "" ? "All patches" : "The patches that are found"}>
        {(
          [
            ["All", withAll],
            ["None", withNone],
            ["Invert", inverted],
          ] as const
        ).map(([text, change]) => (
          <button key={text} type="button" class="button small" onClick={() => apply(change)}>
            {text}
          </button>
        ))}
      </div>
    </div>
  );
}

/** Which groups of patches are unfolded. fold() folds a group or unfolds it. */
function useFolding(): { isOpen: (prefix: string) => boolean; fold: (prefix: string) => void } {
  const [open, setOpen] = useState<ReadonlySet<string>>(new Set());
  return {
    isOpen: (prefix) => open.has(prefix),
    fold: (prefix) => {
      const others = [...open].filter((other) => other !== prefix);
      setOpen(new Set(others.length < open.size ? others : [...others, prefix]));
    },
  };
}

function Whole({ checked, onChange }: { checked: boolean; onChange: Props["onChange"] }): JSX.Element {
  const faces = useModel((model) => model.description.value?.mesh.boundary_faces);
  return (
    <Check
      label="Whole boundary"
      detail={faces === undefined ? undefined : `${formatCount(faces)} faces`}
      checked={checked}
      onChange={(on) => onChange(on ? [] : null)}
    />
  );
}

export function PatchList({ groups, shown = true, onChange }: Props): JSX.Element {
  const description = useModel((model) => model.description.value);
  const [search, setSearch] = useState("");
  const { isOpen, fold } = useFolding();
  const all = patchesOf(description);
  const found = searched(all, search);
  const now = shown ? groups : null;
  const ticked = new Set(shown ? groups : []);
  const set = (to: readonly string[] | null): void => onChange(to === null ? null : [...to]);
  const toggle = (name: string, on: boolean): void => {
    const next = on ? [...ticked, name] : [...ticked].filter((group) => group !== name);
    set(next.length === 0 ? null : next);
  };
  const toggleAll = (patches: readonly Patch[], on: boolean): void =>
    set(on ? withAll(all, now, patches) : withNone(all, now, patches));
  const only = (patches: readonly Patch[]): void => set(patches.map(({ name }) => name));
  return (
    <div class="patches" role="group" aria-label="Patches of the boundary">
      <Whole checked={shown && groups.length === 0} onChange={onChange} />
      {all.length > 1 && (
        <Tools
          search={search}
          setSearch={setSearch}
          hasSearch={all.length > WORTH_A_SEARCH}
          apply={(change) => set(change(all, now, found))}
        />
      )}
      {all.length > 0 && (
        <ul class="patch-list" tabIndex={-1}>
          {families(found, all).map((family) =>
            family.prefix === "" ? (
              family.patches.map((patch) => (
                <PatchRow
                  key={patch.name}
                  patch={patch}
                  prefix=""
                  checked={ticked.has(patch.name)}
                  toggle={toggle}
                  only={only}
                />
              ))
            ) : (
              <Family
                key={family.prefix}
                family={family}
                isOpen={search !== "" || isOpen(family.prefix)}
                fold={() => fold(family.prefix)}
                ticked={ticked}
                toggle={toggle}
                toggleAll={toggleAll}
                only={only}
              />
            ),
          )}
          {found.length === 0 && <li class="hint">No patch has all of these words in its name.</li>}
        </ul>
      )}
    </div>
  );
}
