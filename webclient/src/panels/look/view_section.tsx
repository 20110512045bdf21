import type { JSX } from "preact";
import { DEFAULTS } from "../../generated/protocol";
import type { StreamChoice } from "../../model/state";
import { layersOf } from "../../model/scalars";
import { Check, Section, SelectField } from "../controls/controls";
import { DEFAULT_SOLID } from "../color/coloring";
import { AnnotationFields } from "./annotation_fields";
import { useCommands, useLayers, useModel } from "../context";

const STREAMS = [
  { value: "auto", text: "Automatic" },
  { value: "image", text: "Images" },
  { value: "jpeg", text: "Images, JPEG while moving" },
  { value: "geometry", text: "Geometry" },
];
const CUSTOM = "custom";
const BACKGROUNDS = [
  { value: "dark", text: "Dark" },
  { value: "light", text: "Light" },
  { value: CUSTOM, text: "One color" },
];

interface ColorInputProps {
  label: string;
  /** Name of the input for screen readers. */
  of: string;
  value: string;
  onChange: (color: string) => void;
}

function ColorInput({ label, of, value, onChange }: ColorInputProps): JSX.Element {
  return (
    <label class="field">
      <span>{label}</span>
      <input type="color" aria-label={of} value={value} onChange={(event) => onChange(event.currentTarget.value)} />
    </label>
  );
}

export function ViewSection(): JSX.Element {
  const commands = useCommands();
  const layers = useLayers();
  const background = useModel((model) => model.scene.value?.background) ?? DEFAULTS.Scene.background;
  const annotations = useModel((model) => model.scene.value?.annotations) ?? {};
  const choice = useModel((model) => model.streamChoice.value);
  const why = useModel((model) => model.streamWhy.value);
  const [outline] = layersOf(layers, "outline");
  const own = background.startsWith("#");
  const toggleOutline = (visible: boolean): void => {
    if (outline !== undefined) commands.layers.set(outline[0], { visible });
    else commands.layers.add("outline", { type: "outline" });
  };
  return (
    <Section title="View">
      <div class="fields">
        <SelectField
          label="Background"
          value={own ? CUSTOM : background}
          options={BACKGROUNDS}
          onChange={(value) => commands.change({ background: value === CUSTOM ? "#ffffff" : value })}
        />
        <SelectField
          label="Stream"
          value={choice}
          options={STREAMS}
          onChange={(value) => commands.page.chooseStream(value as StreamChoice)}
        />
        {choice === "auto" && why !== "" && (
          <p class="hint" data-readout="stream-why">
            {why}
          </p>
        )}
        {own && (
          <ColorInput
            label="Color"
            of="Background color"
            value={background}
            onChange={(color) => commands.change({ background: color })}
          />
        )}
      </div>
      <Check label="Outline" checked={outline !== undefined && outline[1].visible !== false} onChange={toggleOutline} />
      {outline !== undefined && outline[1].visible !== false && (
        <ColorInput
          label="Color of the outline"
          of="Color of the outline"
          value={outline[1].color?.solid ?? DEFAULT_SOLID}
          onChange={(solid) => commands.colors.set({ layers: [outline[0]] }, { solid })}
        />
      )}
      <AnnotationFields
        annotations={annotations}
        change={(annotations, gesture) => commands.change({ annotations }, gesture)}
        newGesture={() => commands.newGesture()}
      />
    </Section>
  );
}
