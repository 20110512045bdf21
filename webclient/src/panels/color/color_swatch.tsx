// A color scale as a horizontal bar, and a gallery of color maps.
import type { JSX } from "preact";
import { colorMapKinds } from "../../model/color_maps";
import { colorsAlong, type ColorScale } from "../../model/color_scale";

const STOPS = 33;

export function gradientOf(scale: ColorScale): string {
  const steps = scale.steps > 1 ? scale.steps : 0;
  const colors = colorsAlong(scale, steps === 0 ? (scale.points.length > 0 ? 4 * STOPS : STOPS) : steps);
  const css = colors.map((color, i) => {
    const name = `rgb(${color.join(" ")})`;
    return steps === 0 ? name : `${name} ${(100 * i) / steps}% ${(100 * (i + 1)) / steps}%`;
  });
  return `linear-gradient(to right, ${css.join(", ")})`;
}

const KIND_NAMES: Record<string, string> = { sequential: "Sequential", diverging: "Diverging", cyclic: "Cyclic" };

interface GalleryProps {
  /** Color scale whose direction and number of steps apply to all swatches. */
  scale: ColorScale;
  onChoose: (map: string) => void;
}

export function MapGallery({ scale, onChoose }: GalleryProps): JSX.Element {
  const own = scale.points.length > 0;
  return (
    <div class="map-gallery">
      {colorMapKinds().map(({ kind, names }) => (
        <div key={kind} role="group" aria-label={`${KIND_NAMES[kind] ?? kind} color maps`}>
          <small>{KIND_NAMES[kind] ?? kind}</small>
          <div class="swatches">
            {names.map((map) => (
              <button
                key={map}
                type="button"
                class="swatch"
                aria-label={`Color map ${map}`}
                aria-pressed={!own && map === scale.map}
                title={map}
                style={{ background: gradientOf({ ...scale, map, points: [] }) }}
                onClick={() => onChoose(map)}
              />
            ))}
          </div>
        </div>
      ))}
    </div>
  );
}
