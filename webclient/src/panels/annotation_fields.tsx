// What is written over the view here and over saved pictures by the server.
import type { JSX } from "preact";
import type { Annotations } from "../generated/protocol";
import { Check } from "./controls";

interface AnnotationFieldsProps {
  annotations: Annotations;
  change: (annotations: Annotations) => void;
}

export function AnnotationFields({ annotations, change }: AnnotationFieldsProps): JSX.Element {
  const { legend = true, triad = true, axes = false, dataset = false, time = false, title = "" } = annotations;
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
          value={title}
          maxLength={200}
          placeholder="none"
          onChange={(event) => change({ title: event.currentTarget.value })}
        />
      </label>
    </>
  );
}
