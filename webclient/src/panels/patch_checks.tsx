// Which of the boundary a layer shows: the whole of it, or named patches.
import type { JSX } from "preact";
import { formatCount } from "../scene/numbers";
import { Check } from "./controls";
import { useAppState } from "./context";

interface Props {
  /** Patches; none stands for the whole boundary. */
  groups: readonly string[];
  /** False where the layer is hidden, so that nothing is ticked. */
  shown?: boolean;
  /** null: nothing is ticked any more. */
  onChange: (groups: string[] | null) => void;
}

export function PatchChecks({ groups, shown = true, onChange }: Props): JSX.Element {
  const description = useAppState((state) => state.description);
  const patches = (description?.groups ?? []).filter(({ of }) => of === "faces");
  const whole = shown && groups.length === 0;
  const toggle = (name: string, on: boolean): void => {
    const before = shown ? groups : [];
    const next = on ? [...before, name] : before.filter((group) => group !== name);
    onChange(next.length === 0 ? null : next);
  };
  return (
    <>
      <Check
        label="Whole boundary"
        detail={description === null ? undefined : `${formatCount(description.mesh.boundary_faces)} faces`}
        checked={whole}
        onChange={(on) => onChange(on ? [] : null)}
      />
      {patches.map(({ name, count }) => (
        <Check
          key={name}
          label={name}
          detail={`${formatCount(count)} faces`}
          checked={shown && groups.includes(name)}
          onChange={(on) => toggle(name, on)}
        />
      ))}
    </>
  );
}
