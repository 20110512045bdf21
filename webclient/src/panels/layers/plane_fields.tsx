// Fields of a free plane: position along the plane's normal, origin, normal.
import type { JSX } from "preact";
import { boundsCenter, corners, frame } from "../../model/camera";
import { add, dot, normalize, scale, subtract } from "../../model/vector";
import type { Vec3 } from "../../generated/protocol";
import { clamp, formatNumber, sliderTrack } from "../../model/numbers";
import { IconButton, Slider } from "../controls/controls";
import { useCommands, useModel } from "../context";
import { VectorRow } from "../controls/vector_row";

/** Rounds to six significant digits, which are enough for positions in a dataset. */
const tidy = (vector: Vec3): Vec3 => vector.map((value) => Number(value.toPrecision(6))) as Vec3;

interface PlaneProps {
  id: string;
  origin: Vec3;
  normal: Vec3;
}

export function PlaneFields({ id, origin, normal }: PlaneProps): JSX.Element {
  const commands = useCommands();
  const description = useModel((model) => model.description.value);
  const direction = normalize(normal);
  const center = description === null ? origin : boundsCenter(description.bounds);
  const reach =
    description === null
      ? 1
      : Math.max(...corners(description.bounds).map((at) => dot(subtract(at, center), direction)));
  const offset = dot(subtract(origin, center), direction);
  const moveTo = (to: number, gesture?: string): void =>
    commands.layers.set(id, { origin: tidy(add(origin, scale(direction, to - offset))) }, gesture);
  const face = (): void => {
    const camera = commands.camera.get();
    if (camera !== null)
      commands.layers.set(id, { origin: tidy(center), normal: tidy(scale(frame(camera).forward, -1)) });
  };
  return (
    <>
      <Slider
        label="Position along the normal"
        {...sliderTrack([-reach, reach])}
        value={offset}
        text={`${formatNumber(offset, reach)} ${description?.length_units ?? ""} from the middle`}
        newGesture={() => commands.newGesture()}
        onChange={(to, gesture) => moveTo(clamp(to, -reach, reach), gesture)}
      />
      <VectorRow label="Origin" value={origin} span={2 * reach} set={(to) => commands.layers.set(id, { origin: to })} />
      <VectorRow
        label="Normal"
        value={normal}
        span={10 * Math.hypot(...normal)}
        set={(to) => {
          if (to.some((part) => part !== 0)) commands.layers.set(id, { normal: to });
          else commands.tell("A normal of 0, 0, 0 has no direction; type a nonzero component first", "error");
        }}
      />
      <IconButton icon="eye" label="Turn the plane to face the view" text="Face the view" onClick={face} />
    </>
  );
}
