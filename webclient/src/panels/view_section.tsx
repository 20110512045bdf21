import type { JSX } from "preact";
import type { StreamChoice } from "../app/state";
import { layersOf } from "../scene/scalars";
import { Check, Section, SelectField } from "./controls";
import { DEFAULT_SOLID } from "./coloring";
import { AnnotationFields } from "./annotation_fields";
import { useApp, useAppState } from "./context";

const STREAMS = [
  { value: "auto", text: "Automatic" },
  { value: "image", text: "Images" },
  { value: "jpeg", text: "Images, JPEG while moving" },
  { value: "geometry", text: "Geometry" },
];
const CUSTOM = "custom";

export function ViewSection(): JSX.Element {
  const { actions, editor, streams } = useApp();
  const scene = useAppState((state) => state.scene);
  const choice = useAppState((state) => state.streamChoice);
  const why = useAppState((state) => state.streamWhy);
  const [outline] = layersOf(scene, "outline");
  const background = scene?.background ?? "dark";
  const own = background.startsWith("#");
  const toggleOutline = (visible: boolean): void => {
    if (outline !== undefined) actions.setLayer(outline[0], { visible });
    else actions.addLayer("outline", { type: "outline" });
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
            { value: CUSTOM, text: "One colour" },
          ]}
          onChange={(value) => editor.change({ background: value === CUSTOM ? "#ffffff" : value })}
        />
        <SelectField
          label="Stream"
          value={choice}
          options={STREAMS}
          onChange={(value) => streams.choose(value as StreamChoice)}
        />
        {choice === "auto" && why !== "" && (
          <p class="hint" data-readout="stream-why">
            {why}
          </p>
        )}
        {own && (
          <label class="field">
            <span>Colour</span>
            <input
              type="color"
              aria-label="Background colour"
              value={background}
              onChange={(event) => editor.change({ background: event.currentTarget.value })}
            />
          </label>
        )}
      </div>
      <Check label="Outline" checked={outline !== undefined && outline[1].visible !== false} onChange={toggleOutline} />
      {outline !== undefined && outline[1].visible !== false && (
        <label class="field">
          <span>Colour of the outline</span>
          <input
            type="color"
            aria-label="Colour of the outline"
            value={outline[1].color?.solid ?? DEFAULT_SOLID}
            onChange={(event) => actions.setColoring({ layers: [outline[0]] }, { solid: event.currentTarget.value })}
          />
        </label>
      )}
      <AnnotationFields
        annotations={scene?.annotations ?? {}}
        change={(annotations, gesture) => editor.change({ annotations }, gesture)}
        newGesture={() => editor.newGesture()}
      />
    </Section>
  );
}
