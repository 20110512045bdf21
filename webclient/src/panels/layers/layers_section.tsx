// List of all layers in their order. A layer can be shown, hidden, and moved by dragging or by buttons.
import type { JSX, RefObject } from "preact";
import { useEffect, useRef, useState, type MutableRef } from "preact/hooks";
import { layerNames } from "../../model/layer_names";
import { layersInOrder } from "../../model/layer_order";
import { IconButton, Section } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";

type Step = "up" | "down";
type Drag = { id: string; over: number | null } | null;

interface RowProps {
  id: string;
  name: string;
  visible: boolean;
  /** Reason why the layer shows nothing. Empty if the layer shows something. */
  reason: string;
  place: number;
  count: number;
  move: (step: Step) => void;
  /** Where the dragged layer would be dropped: above this row or, only for the last row, below it. null: elsewhere. */
  mark: "above" | "below" | null;
  drag: { begin: () => void; over: (below: boolean) => void; end: (dropped: boolean) => void };
}

function LayerRow({ id, name, visible, reason, place, count, move, mark, drag }: RowProps): JSX.Element {
  const commands = useCommands();
  return (
    <li
      class={`layer-row ${visible ? "" : "off"} ${mark ?? ""}`}
      data-layer={id}
      draggable
      onDragStart={(event) => {
        event.dataTransfer?.setData("text/plain", name);
        drag.begin();
      }}
      onDragOver={(event) => {
        const box = event.currentTarget.getBoundingClientRect();
        event.preventDefault();
        drag.over(event.clientY > box.top + box.height / 2);
      }}
      onDrop={(event) => {
        event.preventDefault();
        drag.end(true);
      }}
      onDragEnd={() => drag.end(false)}
    >
      <IconButton
        icon={visible ? "eye" : "hidden"}
        label={visible ? "Hide this layer" : "Show this layer"}
        pressed={visible}
        onClick={() => commands.layers.set(id, { visible: !visible })}
      />
      <span class="layer-name" title={name}>
        {name}
      </span>
      {visible && reason !== "" && (
        <p class="hint layer-empty" role="status">
          The layer shows nothing. {reason}
        </p>
      )}
      <IconButton icon="up" label="Move this layer up" disabled={place === 0} onClick={() => move("up")} />
      <IconButton
        icon="down"
        label="Move this layer down"
        disabled={place === count - 1}
        onClick={() => move("down")}
      />
    </li>
  );
}

/**
 * Gives the focus back to the button that has moved a row, because a moved row loses the focus. At an end of the list,
 * this button is disabled, and the button of the opposite direction gets the focus.
 */
function useFocusOfMoved(
  list: RefObject<HTMLOListElement>,
  moved: MutableRef<{ id: string; step: Step } | null>,
  order: string,
): void {
  useEffect(() => {
    const { id, step } = moved.current ?? {};
    moved.current = null;
    const row = [...(list.current?.children ?? [])].find((other) => (other as HTMLElement).dataset.layer === id);
    const [, up, down] = row?.querySelectorAll("button") ?? [];
    const [first, second] = step === "up" ? [up, down] : [down, up];
    (first?.disabled === true ? second : first)?.focus();
  }, [order]);
}

export function LayersSection(): JSX.Element {
  const commands = useCommands();
  const layered = useLayers();
  const empty = useModel((model) => model.empty.value);
  const list = useRef<HTMLOListElement>(null);
  const moved = useRef<{ id: string; step: Step } | null>(null);
  const [drag, setDrag] = useState<Drag>(null);
  const layers = layersInOrder(layered);
  const names = layerNames(layered);
  const order = JSON.stringify(layers.map(([id]) => id));
  useFocusOfMoved(list, moved, order);
  const drop = (dropped: boolean): void => {
    const from = layers.findIndex(([id]) => id === drag?.id);
    if (dropped && drag !== null && drag.over !== null && from >= 0)
      commands.layers.move(drag.id, drag.over > from ? drag.over - 1 : drag.over);
    setDrag(null);
  };
  const markOf = (place: number): "above" | "below" | null => {
    if (drag?.over === place) return "above";
    return drag?.over === layers.length && place === layers.length - 1 ? "below" : null;
  };
  return (
    <Section title="Layers" open={false}>
      {layers.length === 0 ? (
        <p class="hint">None. The sections below add some.</p>
      ) : (
        <ol
          class="layer-list"
          ref={list}
          title="Legends have this order. Where surfaces coincide, the last one is visible."
        >
          {layers.map(([id, layer], place) => (
            <LayerRow
              key={id}
              id={id}
              name={names.get(id) ?? id}
              visible={layer.visible !== false}
              reason={empty.find((one) => one.layer === id)?.reason ?? ""}
              place={place}
              count={layers.length}
              mark={markOf(place)}
              move={(step) => {
                moved.current = { id, step };
                commands.layers.move(id, place + (step === "up" ? -1 : 1));
              }}
              drag={{
                begin: () => setDrag({ id, over: null }),
                over: (below) => setDrag((now) => now && { ...now, over: place + (below ? 1 : 0) }),
                end: drop,
              }}
            />
          ))}
        </ol>
      )}
    </Section>
  );
}
