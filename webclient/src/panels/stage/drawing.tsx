// Draws the overlay of a layout (../../model/layout.ts) as SVG.
import type { JSX } from "preact";
import type { Fill, Overlay } from "../../model/layout";

/** Width of the halo on each side of a letter's outline, in CSS pixels. */
const HALO = 1.5;

function Fills({ fills, name }: { fills: readonly Fill[]; name: string }): JSX.Element {
  return (
    <>
      {fills.map(({ box, top, bottom }, i) => {
        const id = `${name} fill ${i}`.replaceAll(" ", "-");
        return (
          <g key={id}>
            {top !== bottom && (
              <linearGradient id={id} x1="0" y1="0" x2="0" y2="1">
                <stop offset="0" stop-color={top} />
                <stop offset="1" stop-color={bottom} />
              </linearGradient>
            )}
            <rect
              class="fill"
              x={box.left}
              y={box.top}
              width={box.right - box.left}
              height={box.bottom - box.top}
              fill={top === bottom ? top : `url(#${id})`}
            />
          </g>
        );
      })}
    </>
  );
}

/** `name` must be unique in the document. */
export function Drawing({ overlay, name }: { overlay: Overlay; name: string }): JSX.Element {
  const { plates, fills, strokes, triangles, labels, halo } = overlay;
  return (
    <>
      {plates.map(({ box, edge, ink }, i) => (
        <rect
          key={`plate ${i}`}
          class="plate"
          x={box.left - edge}
          y={box.top - edge}
          width={box.right - box.left + 2 * edge}
          height={box.bottom - box.top + 2 * edge}
          rx={edge}
          fill={ink}
        />
      ))}
      <Fills fills={fills} name={name} />
      {strokes.map(({ from, to, width, ink }, i) => (
        <line key={`stroke ${i}`} x1={from.x} y1={from.y} x2={to.x} y2={to.y} stroke={ink} stroke-width={width} />
      ))}
      {triangles.map(({ corners, ink }, i) => (
        <polygon key={`triangle ${i}`} points={corners.map(({ x, y }) => `${x},${y}`).join(" ")} fill={ink} />
      ))}
      {labels.map(({ text, pixels, at, ink }, i) => (
        <text
          key={`label ${i}`}
          x={at.x}
          y={at.y}
          font-size={pixels}
          fill={ink}
          stroke={halo}
          stroke-width={2 * HALO}
          paint-order="stroke"
        >
          {text}
        </text>
      ))}
    </>
  );
}
