// Which cells of the mesh a layer shows: those whose values lie in a range.
import type { JSX } from "preact";
import type { Range, Threshold } from "../generated/protocol";
import { arrayOf, shownTime, thresholdScalarsOf } from "../scene/scalars";
import { Check, NumberField, SelectField } from "./controls";
import { useApp, useAppState } from "./context";

interface ThresholdProps {
  id: string;
  threshold: Threshold | undefined;
  /** The array that colours the layer, which is what a threshold begins with. */
  color: string | undefined;
}

export function ThresholdFields({ id, threshold, color }: ThresholdProps): JSX.Element | null {
  const { actions, histograms } = useApp();
  const description = useAppState((state) => state.description);
  const scene = useAppState((state) => state.scene);
  useAppState((state) => state.histogramsAt);
  const scalars = thresholdScalarsOf(description);
  const first = color ?? scalars[0]?.name;
  if (first === undefined || description === null) return null;
  const shown = threshold !== undefined && threshold.enabled !== false;
  const wholeOf = (array: string): Range => {
    const known = histograms.get(description.name, array, shownTime(description, scene));
    return known?.range ?? arrayOf(description, array)?.range ?? [0, 1];
  };
  const set = (change: Partial<Threshold>): void => actions.setLayer(id, { threshold: change });
  // The upper half: everything would look as if nothing had happened.
  const begin = (array: string): void => {
    const [low, high] = wholeOf(array);
    set({ enabled: true, array, range: [(low + high) / 2, high] });
  };
  const whole = wholeOf(threshold?.array ?? first);
  return (
    <>
      <Check
        label="Threshold"
        checked={shown}
        onChange={(enabled) => (threshold === undefined ? begin(first) : set({ enabled }))}
      />
      {shown && (
        <>
          <div class="fields">
            <SelectField
              label="Cells by"
              value={threshold.array}
              options={scalars.map(({ name }) => ({ value: name, text: name }))}
              onChange={begin}
            />
            {arrayOf(description, threshold.array)?.association !== "cell" && (
              <SelectField
                label="Of their vertices"
                value={threshold.keep ?? "all"}
                options={[
                  { value: "all", text: "all in range" },
                  { value: "any", text: "any in range" },
                ]}
                onChange={(keep) => set({ keep: keep as "all" | "any" })}
              />
            )}
          </div>
          <div class="vector-row">
            <span>Range</span>
            {([0, 1] as const).map((end) => (
              <NumberField
                key={end}
                label={end === 0 ? "Threshold from" : "Threshold to"}
                value={threshold.range[end]}
                span={whole[1] - whole[0]}
                onChange={(typed) => {
                  const other = threshold.range[1 - end] ?? typed;
                  set({ range: end === 0 ? [typed, Math.max(typed, other)] : [Math.min(typed, other), typed] });
                }}
              />
            ))}
          </div>
        </>
      )}
    </>
  );
}
