// Switches for annotations over the picture. Saved pictures have the same annotations, drawn by the server.
import type { JSX } from "preact";
import { DEFAULTS, type Annotations } from "../../generated/protocol";
import { Check, Slider } from "../controls/controls";

interface AnnotationFieldsProps {
  annotations: Annotations;
  change: (annotations: Annotations, gesture?: string) => void;
  newGesture: () => string;
}

export function AnnotationFields({ annotations, change, newGesture }: AnnotationFieldsProps): JSX.Element {
  const { legend, triad, axes, dataset, time, title, scale } = { ...DEFAULTS.Annotations, ...annotations };
  const percent = Math.round(100 * scale);
  return (
    <>
      <Check label="Legend" checked={legend} onChange={(shown) => change({ legend: shown })} />
      <Check label="Axes triad" checked={triad} onChange={(shown) => change({ triad: shown })} />
      <Check label="Axes of the box" checked={axes} onChange={(shown) => change({ axes: shown })} />
      <Check label="Dataset name" checked={dataset} onChange={(shown) => change({ dataset: shown })} />
      <Check label="Time" checked={time} onChange={(shown) => change({ time: shown })} />
      <label class="field">
        <span>Title</span>
        <input
          type="text"
          class="text-field"
          value={title}
          maxLength={200}
          placeholder="none"
          onChange={(event) => change({ title: event.currentTarget.value })}
        />
      </label>
      <div class="field opacity">
        <span>Text size</span>
        <Slider
          label="Text size"
          min={50}
          max={300}
          step={10}
          value={percent}
          text={`${percent} %`}
          newGesture={newGesture}
          onChange={(value, gesture) => change({ scale: value / 100 }, gesture)}
        />
        <output>{percent} %</output>
      </div>
    </>
  );
}
