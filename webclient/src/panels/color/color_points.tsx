// Editor for custom colors of a scale: points on a bar, moved by pointer or keyboard, and fields for each point.
import type { JSX } from "preact";
import { colorOf, hexOf, placeOf, valueAtPlace, type ColorScale } from "../../model/color_scale";
import type { ColorPoint, Range } from "../../generated/protocol";
import { addedPoint, MOST_POINTS, movedPoint } from "../../model/color_edit";
import { clamp, formatNumber } from "../../model/numbers";
import { gradientOf } from "./color_swatch";
import { IconButton, NumberField } from "../controls/controls";
import { useCommands } from "../context";
import { useHandleDrag } from "../controls/handle_drag";
import { RemoveButton } from "../controls/remove_button";

const KEY_STEPS: Record<string, number> = {
  ArrowRight: 0.01,
  ArrowUp: 0.01,
  ArrowLeft: -0.01,
  ArrowDown: -0.01,
  PageUp: 0.1,
  PageDown: -0.1,
  Home: -1,
  End: 1,
};

interface Props {
  scale: ColorScale;
  onChange: (points: ColorPoint[], gesture?: string) => void;
}

/** Rounds a position on the bar to 1/10000, which is less than a pixel. */
const rounded = (at: number): number => Number(at.toFixed(4));

/** Converts a position on the scale to a position on the bar, or back. The bar of a reversed scale is mirrored. */
const turned = ({ reverse }: ColorScale, at: number): number => (reverse ? rounded(1 - at) : at);

function valuesBetween(scale: ColorScale, index: number): Range {
  const places = [scale.points[index - 1]?.at ?? 0, scale.points[index + 1]?.at ?? 1];
  const [a = 0, b = 0] = places.map((at) => Number(valueAtPlace(scale, turned(scale, at)).toPrecision(6)));
  return [Math.min(a, b), Math.max(a, b)];
}

function PointsBar({ scale, onChange }: Props): JSX.Element {
  const commands = useCommands();
  const { points } = scale;
  const move = (index: number, at: number, gesture: string): void =>
    onChange(movedPoint(points, index, turned(scale, rounded(clamp(at, 0, 1)))), gesture);
  const { track, pointer, keyGesture } = useHandleDrag({
    newGesture: () => commands.newGesture(),
    pressed: () => null,
    moved: (index, { x }, gesture) => move(index, x, gesture),
  });
  const onKeyDown = (event: KeyboardEvent, index: number): void => {
    const step = KEY_STEPS[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    move(index, turned(scale, points[index]?.at ?? 0) + step, keyGesture(event));
  };
  return (
    <div class="points-bar" ref={track} style={{ background: gradientOf({ ...scale, steps: 0 }) }} {...pointer}>
      {points.map(({ at: own, color }, index) => {
        const at = turned(scale, own);
        return (
          <div
            key={index}
            class="point-handle"
            data-index={index}
            role="slider"
            tabIndex={0}
            aria-label={`Place of color ${index + 1}`}
            aria-valuemin={0}
            aria-valuemax={100}
            aria-valuenow={Math.round(100 * at)}
            aria-valuetext={`${Math.round(100 * at)} %, ${formatNumber(valueAtPlace(scale, at))}`}
            style={{ left: `${100 * at}%`, background: color }}
            onKeyDown={(event) => onKeyDown(event, index)}
          />
        );
      })}
    </div>
  );
}

export function PointsEditor({ scale, onChange }: Props): JSX.Element {
  const { points } = scale;
  const span = scale.log ? undefined : scale.range[1] - scale.range[0];
  const unturned = { ...scale, reverse: false, steps: 0 };
  const colorAt = (place: number): string => hexOf(colorOf(unturned, valueAtPlace(scale, place)));
  return (
    <div class="points-editor" data-list="">
      <PointsBar scale={scale} onChange={onChange} />
      {points.map(({ at, color }, index) => (
        <div class="point-row" key={index}>
          <input
            type="color"
            aria-label={`Color ${index + 1}`}
            value={color}
            onChange={(event) => {
              const chosen = event.currentTarget.value;
              onChange(points.map((point, i) => (i === index ? { ...point, color: chosen } : point)));
            }}
          />
          <NumberField
            label={`Value of color ${index + 1}`}
            value={Number(valueAtPlace(scale, turned(scale, at)).toPrecision(6))}
            span={span}
            limits={valuesBetween(scale, index)}
            onChange={(value) =>
              onChange(movedPoint(points, index, turned(scale, rounded(clamp(placeOf(scale, value), 0, 1)))))
            }
          />
          <RemoveButton
            label={`Remove color ${index + 1}`}
            disabled={points.length <= 2}
            onClick={() => onChange(points.filter((_, i) => i !== index))}
          />
        </div>
      ))}
      {points.length < MOST_POINTS && (
        <IconButton
          icon="plus"
          label="Add a color"
          text="Color"
          onClick={() => onChange(addedPoint(points, colorAt))}
        />
      )}
    </div>
  );
}
