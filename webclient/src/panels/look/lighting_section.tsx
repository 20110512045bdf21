// Settings of a scene's lights and of ambient occlusion.
import type { JSX } from "preact";
import { DEFAULTS, type AmbientOcclusion, type Light, type Lighting } from "../../generated/protocol";
import { Check, Section, Slider } from "../controls/controls";
import { useCommands, useModel } from "../context";

interface StrengthProps {
  label: string;
  /** Strength or radius; 1 is shown as 100 %. */
  value: number;
  most: number;
  least?: number;
  onChange: (value: number, gesture: string) => void;
}

function Strength({ label, value, most, least = 0, onChange }: StrengthProps): JSX.Element {
  const commands = useCommands();
  const percent = Math.round(value * 100);
  return (
    <div class="field opacity">
      <span>{label}</span>
      <Slider
        label={label}
        min={100 * least}
        max={100 * most}
        step={most > 1 ? 5 : 1}
        value={percent}
        text={`${percent} %`}
        newGesture={() => commands.newGesture()}
        onChange={(changed, gesture) => onChange(changed / 100, gesture)}
      />
      <output>{percent} %</output>
    </div>
  );
}

interface LightFieldsProps {
  label: string;
  light: Light | undefined;
  change: (light: Light, gesture?: string) => void;
}

function LightFields({ label, light, change }: LightFieldsProps): JSX.Element {
  const { on, strength } = { ...DEFAULTS.Light, ...light };
  return (
    <>
      <Check label={label} checked={on} onChange={(checked) => change({ on: checked })} />
      {on && (
        <Strength
          label={`Strength of the ${label.toLowerCase()}`}
          value={strength}
          most={2}
          onChange={(value, gesture) => change({ strength: value }, gesture)}
        />
      )}
    </>
  );
}

interface OcclusionFieldsProps {
  occlusion: AmbientOcclusion | undefined;
  change: (occlusion: AmbientOcclusion, gesture?: string) => void;
}

function OcclusionFields({ occlusion, change }: OcclusionFieldsProps): JSX.Element {
  const { on, radius, strength } = { ...DEFAULTS.AmbientOcclusion, ...occlusion };
  return (
    <>
      <Check label="Ambient occlusion" checked={on} onChange={(checked) => change({ on: checked })} />
      {on && (
        <>
          <Strength
            label="Radius of the occlusion"
            value={radius}
            least={0.01}
            most={0.5}
            onChange={(value, gesture) => change({ radius: value }, gesture)}
          />
          <Strength
            label="Strength of the occlusion"
            value={strength}
            most={3}
            onChange={(value, gesture) => change({ strength: value }, gesture)}
          />
        </>
      )}
    </>
  );
}

export function LightingSection(): JSX.Element {
  const commands = useCommands();
  const lighting: Lighting = useModel((model) => model.scene.value?.lighting) ?? {};
  const { on, ambient } = { ...DEFAULTS.Lighting, ...lighting };
  const change = (part: Lighting, gesture?: string): void => commands.change({ lighting: part }, gesture);
  return (
    <Section title="Lighting" open={false}>
      <Check label="Lights" checked={on} onChange={(checked) => change({ on: checked })} />
      {on && (
        <>
          <LightFields
            label="Headlight"
            light={lighting.headlight}
            change={(headlight, gesture) => change({ headlight }, gesture)}
          />
          <LightFields
            label="Key light"
            light={lighting.key_light}
            change={(key_light, gesture) => change({ key_light }, gesture)}
          />
          <Strength
            label="Light from everywhere"
            value={ambient}
            most={2}
            onChange={(value, gesture) => change({ ambient: value }, gesture)}
          />
          <OcclusionFields
            occlusion={lighting.ambient_occlusion}
            change={(ambient_occlusion, gesture) => change({ ambient_occlusion }, gesture)}
          />
        </>
      )}
    </Section>
  );
}
