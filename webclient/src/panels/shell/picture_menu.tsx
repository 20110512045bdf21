// Menu that saves a picture in a size that the user chooses, for example for a poster or a slide.
import type { JSX } from "preact";
import { useState } from "preact/hooks";
import type { Size } from "../../model/camera";
import { LARGEST, SMALLEST } from "../../model/canvas_size";
import type { Range } from "../../generated/protocol";
import { Menu, NumberField } from "../controls/controls";
import { useCommands } from "../context";

const FACTORS = [1, 2, 4];
/** Common picture sizes in pixels. A4 is landscape with 300 pixels per inch. */
const USUAL: readonly { name: string; size: Size }[] = [
  { name: "HD", size: { width: 1920, height: 1080 } },
  { name: "4K", size: { width: 3840, height: 2160 } },
  { name: "A4", size: { width: 3508, height: 2480 } },
];
const SIDES: Range = [SMALLEST, LARGEST];

function Sides({ size, onChange }: { size: Size; onChange: (size: Size) => void }): JSX.Element {
  const { width, height } = size;
  return (
    <div class="range-row">
      <NumberField
        label="Width of the picture in pixels"
        value={width}
        limits={SIDES}
        onChange={(typed) => onChange({ width: Math.round(typed), height })}
      />
      <span aria-hidden="true">×</span>
      <NumberField
        label="Height of the picture in pixels"
        value={height}
        unit="px"
        limits={SIDES}
        onChange={(typed) => onChange({ width, height: Math.round(typed) })}
      />
    </div>
  );
}

export function PictureMenu({ disabled }: { disabled: boolean }): JSX.Element {
  const commands = useCommands();
  const [chosen, setChosen] = useState<Size | null>(null);
  const { width, height } = chosen ?? commands.page.pictureSize();
  return (
    <Menu icon="poster" label="Pictures of other sizes" disabled={disabled}>
      {(close) => (
        <>
          <Sides size={{ width, height }} onChange={setChosen} />
          <div class="row" role="group" aria-label="Times the size of the view">
            {FACTORS.map((factor) => (
              <button
                key={factor}
                type="button"
                class="button small"
                aria-label={`${factor} times as large as the view`}
                onClick={() => setChosen(factor === 1 ? null : commands.page.pictureSize(factor))}
              >
                ×{factor}
              </button>
            ))}
          </div>
          <div class="row" role="group" aria-label="Usual sizes">
            {USUAL.map(({ name, size: usual }) => (
              <button
                key={name}
                type="button"
                class="button small"
                title={`${usual.width} × ${usual.height} pixels${name === "A4" ? ": 300 an inch, lying on its side" : ""}`}
                onClick={() => setChosen(usual)}
              >
                {name}
              </button>
            ))}
          </div>
          <button
            type="button"
            class="button"
            onClick={() => {
              close();
              void commands.files.screenshot({ width, height });
            }}
          >
            Save
          </button>
        </>
      )}
    </Menu>
  );
}
