// Colour bars over the canvas, one per colouring in use; the range is edited in place.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { colorMap, DEFAULT_MAP } from "../display/color_maps";
import type { Coloring, Range } from "../generated/protocol";
import { formatNumber, fractionOf, ticks } from "../scene/numbers";
import { legendsOf, shownTime, unitsOf } from "../scene/scalars";
import { IconButton, NumberField } from "./controls";
import { useApp, useAppState } from "./context";

function ColorBar({ map }: { map: string }): JSX.Element {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    context?.putImageData(new ImageData(new Uint8ClampedArray(colorMap(map)), 256, 1), 0, 0);
  }, [map]);
  return <canvas ref={canvas} class="color-bar" width={256} height={1} aria-hidden="true" />;
}

interface Entry {
  coloring: Coloring & { array: string };
  layers: string[];
}

function LegendEntry({ coloring, layers }: Entry): JSX.Element {
  const { actions, histograms } = useApp();
  const scene = useAppState((state) => state.scene);
  const description = useAppState((state) => state.description);
  useAppState((state) => state.histogramsAt);
  const units = unitsOf(description, coloring.array);
  const own =
    description === null ? null : histograms.get(description.name, coloring.array, shownTime(description, scene));
  const range: Range | null = coloring.range ?? own?.range ?? null;
  const span = range === null ? 0 : range[1] - range[0];
  const setRange = (low: number, high: number): void =>
    actions.setColoring(layers, { range: low <= high ? [low, high] : [high, low] });
  return (
    <figure class="legend" aria-label={`Colours of ${coloring.array}`}>
      <figcaption>
        {coloring.array}
        {units !== "" && <small> {units}</small>}
        {coloring.range && (
          <IconButton
            icon="reset"
            label={`Range of the data for ${coloring.array}`}
            onClick={() => actions.setColoring(layers, { range: undefined })}
          />
        )}
      </figcaption>
      <ColorBar map={coloring.map ?? DEFAULT_MAP} />
      {range !== null && (
        <>
          <div class="ticks" aria-hidden="true">
            {ticks(range)
              .map((value) => ({ value, at: fractionOf(value, range) }))
              .filter(({ at }) => at > 0.22 && at < 0.78)
              .map(({ value, at }) => (
                <span key={value} style={{ left: `${at * 100}%` }}>
                  {formatNumber(value, span)}
                </span>
              ))}
          </div>
          <div class="legend-range">
            <NumberField
              label={`Lowest value of the ${coloring.array} colours`}
              value={range[0]}
              span={span}
              onChange={(low) => setRange(low, range[1])}
            />
            <NumberField
              label={`Highest value of the ${coloring.array} colours`}
              value={range[1]}
              span={span}
              onChange={(high) => setRange(range[0], high)}
            />
          </div>
        </>
      )}
    </figure>
  );
}

export function Legends(): JSX.Element | null {
  const scene = useAppState((state) => state.scene);
  if (scene?.legend === false) return null;
  return (
    <div class="legends">
      {legendsOf(scene).map((entry) => (
        <LegendEntry key={`${entry.coloring.array} ${entry.coloring.map ?? ""} ${entry.layers.join(" ")}`} {...entry} />
      ))}
    </div>
  );
}
