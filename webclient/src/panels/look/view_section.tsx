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
          options={[
            { value: "dark", text: "Dark" },
            { value: "light", text: "Light" },
            { value: CUSTOM, text: "One color" },
          ]}
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
          <label class="field">
            <span>Color</span>
            <input
              type="color"
              aria-label="Background color"
              value={background}
              onChange={(event) => commands.change({ background: event.currentTarget.value })}
            />
          </label>
        )}
      </div>
      <Check label="Outline" checked={outline !== undefined && outline[1].visible !== false} onChange={toggleOutline} />
      {outline !== undefined && outline[1].visible !== false && (
        <label class="field">
          <span>Color of the outline</span>
          <input
            type="color"
            aria-label="Color of the outline"
            value={outline[1].color?.solid ?? DEFAULT_SOLID}
            onChange={(event) => commands.colors.set({ layers: [outline[0]] }, { solid: event.currentTarget.value })}
          />
        </label>
      )}
      <AnnotationFields
        annotations={annotations}
        change={(annotations, gesture) => commands.change({ annotations }, gesture)}
        newGesture={() => commands.newGesture()}
      />
    </Section>
  );
}
