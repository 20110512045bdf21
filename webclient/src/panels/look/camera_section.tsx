// Settings of the camera: projection, field of view, view height, and number fields for position, target and up vector.
import type { JSX } from "preact";
import {
  distance,
  FOV_RANGE,
  viewHeight,
  withFieldOfView,
  withParallel,
  withViewHeight,
  type ViewCamera,
} from "../../model/camera";
import { cross, length, subtract } from "../../model/vector";
import type { Vec3 } from "../../generated/protocol";
import { clamp, formatNumber } from "../../model/numbers";
import { Check, NumberField, Section, Slider } from "../controls/controls";
import { cameraOf } from "../../model/model";
import { useCommands, useModel } from "../context";
import { VectorRow } from "../controls/vector_row";

const [NARROWEST, WIDEST] = FOV_RANGE;

function FieldOfView({ fov }: { fov: number }): JSX.Element {
  const commands = useCommands();
  const set = (typed: number, gesture?: string): void =>
    commands.camera.change((camera) => withFieldOfView(camera, clamp(typed, NARROWEST, WIDEST)), gesture);
  return (
    <div class="field" title="How strong the perspective is: the angle from the view's lower to its upper edge">
      <span>Field of view in degrees</span>
      <div class="clip-row">
        <Slider
          label="Field of view"
          min={5}
          max={WIDEST}
          step={1}
          value={fov}
          text={`${formatNumber(fov)}°`}
          newGesture={() => commands.newGesture()}
          onChange={set}
        />
        <NumberField
          label="Field of view in degrees"
          value={fov}
          span={90}
          step={5}
          limits={FOV_RANGE}
          onChange={set}
        />
      </div>
    </div>
  );
}

function Places({ camera }: { camera: ViewCamera }): JSX.Element {
  const commands = useCommands();
  const span = distance(camera);
  const set = (change: Partial<ViewCamera>): void => {
    const next = { ...camera, ...change };
    const sight = subtract(next.target, next.position);
    if (length(sight) === 0)
      commands.tell("The camera's position equals its target; type another position or target", "error");
    else if (length(cross(sight, next.up)) === 0)
      commands.tell("The up vector is parallel to the view direction; type another up vector", "error");
    else commands.camera.set(next);
  };
  return (
    <>
      <VectorRow label="Position" value={camera.position} span={span} set={(position: Vec3) => set({ position })} />
      <VectorRow label="Target" value={camera.target} span={span} set={(target: Vec3) => set({ target })} />
      <VectorRow label="Up" value={camera.up} span={1} set={(up: Vec3) => set({ up })} />
    </>
  );
}

export function CameraSection(): JSX.Element {
  const commands = useCommands();
  const own = useModel((model) => model.scene.value?.camera);
  const units = useModel((model) => model.description.value?.length_units) ?? "";
  const camera = useModel(cameraOf);
  return (
    <Section title="Camera">
      {camera !== null && (
        <>
          <Check
            label="Parallel projection"
            checked={camera.parallel}
            onChange={(parallel) => commands.camera.change((now) => withParallel(now, parallel))}
          />
          {!camera.parallel && <FieldOfView fov={camera.fov} />}
          <label class="field">
            <span>{`Height of the view${units === "" ? "" : ` in ${units}`}${camera.parallel ? "" : ", at the target"}`}</span>
            <NumberField
              label="Height of the view"
              value={viewHeight(camera)}
              onChange={(typed) => {
                if (typed > 0) commands.camera.change((now) => withViewHeight(now, typed));
              }}
            />
          </label>
          <Places camera={{ ...camera, up: own?.up ?? camera.up }} />
        </>
      )}
    </Section>
  );
}
