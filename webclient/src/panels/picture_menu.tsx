// A picture of another size than the canvas: for a poster, or a slide.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { Size } from "../camera/camera";
import { LARGEST, SMALLEST } from "../app/canvas_size";
import { clamp } from "../scene/numbers";
import { Menu, NumberField } from "./controls";
import { useApp } from "./context";

const FACTORS = [1, 2, 4];
const side = (pixels: number): number => clamp(Math.round(pixels), SMALLEST, LARGEST);

export function PictureMenu({ disabled }: { disabled: boolean }): JSX.Element {
  const { actions, size } = useApp();
  const [chosen, setChosen] = useState<Size | null>(null);
  const { width, height } = chosen ?? size.pixels();
  return (
    <Menu icon="poster" label="Pictures of other sizes" disabled={disabled}>
      {(close) => (
        <>
          <div class="range-row">
            <NumberField
              label="Width of the picture in pixels"
              value={width}
              onChange={(typed) => setChosen({ width: side(typed), height })}
            />
            <span aria-hidden="true">×</span>
            <NumberField
              label="Height of the picture in pixels"
              value={height}
              unit="px"
              onChange={(typed) => setChosen({ width, height: side(typed) })}
            />
          </div>
          <div class="row" role="group" aria-label="Times the size of the view">
            {FACTORS.map((factor) => (
              <button
                key={factor}
                type="button"
                class="button small"
                aria-label={`${factor} times as large as the view`}
                onClick={() => setChosen(factor === 1 ? null : size.pixels(factor))}
              >
                ×{factor}
              </button>
            ))}
          </div>
          <button
            type="button"
            class="button"
            onClick={() => {
              close();
              void actions.screenshot({ width, height });
            }}
          >
            Save
          </button>
        </>
      )}
    </Menu>
  );
}
