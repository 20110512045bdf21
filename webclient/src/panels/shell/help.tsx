import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { useCommands, useModel } from "../context";

const ROWS: { title: string; keys: [string, string][] }[] = [
  {
    title: "Mouse and fingers",
    keys: [
      ["Drag", "Turn the view about the point under the cursor"],
      ["Shift-drag, right or middle drag", "Move the view sideways"],
      ["Ctrl-drag", "Roll the view"],
      ["Wheel, pinch", "Zoom towards the cursor"],
      ["Click", "Show the values and the patch at this point"],
      ["Double-click", "Move this point to the middle of the view"],
    ],
  },
  {
    title: "Keys",
    keys: [
      ["Arrow keys", "Turn the view; with Shift move it"],
      ["+ and -", "Zoom"],
      ["R", "Default view of the drawn layers; with Shift of the whole mesh"],
      ["X, Y, Z", "Look along an axis; with Shift from the other side"],
      ["O", "Switch between parallel and perspective view"],
      ["Space", "Play or pause the time steps"],
      [", and .", "Previous or next time step"],
      ["Ctrl-Z, Ctrl-Shift-Z", "Undo, redo"],
      ["S", "Save a picture"],
      ["L", "Copy a link"],
      ["P", "Show or hide the side panel"],
      ["?", "Show this help"],
      ["Esc", "Close the shown values or a dialog"],
    ],
  },
  {
    title: "On an iso-value",
    keys: [
      ["Arrow keys", "Change the value by a small step; with Shift by ten steps"],
      ["Page up, page down", "Change the value by a tenth of the range"],
      ["Home, End", "Set the lowest or highest value of the range"],
    ],
  },
  {
    title: "On the opacity curve of a volume",
    keys: [
      ["Click beside the points", "Add a point"],
      ["Drag, arrow keys", "Move a point; with Shift and an arrow key by ten steps"],
      ["Delete, double click", "Remove a point"],
    ],
  },
  {
    title: "On a legend",
    keys: [
      ["A number at an end", "Type another value; the range then stays fixed at all steps"],
      ["The pin", "Use the range of the whole dataset at every step"],
      ["The arrow in a circle", "Use the range of each step again"],
      ["this step, all steps, held", "Where the range comes from: this step, all steps, or your own values"],
      ["A triangle at an end", "Color of values outside the range"],
    ],
  },
  {
    title: "In the list of layers",
    keys: [
      ["Drag a row", "Change the order of the layers"],
      ["The arrows of a row", "Move the row up or down by keys or touch"],
    ],
  },
];

export function Help(): JSX.Element | null {
  const commands = useCommands();
  const open = useModel((model) => model.helpOpen.value);
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    if (open) dialog.current?.showModal();
  }, [open]);
  if (!open) return null;
  const close = (): void => commands.page.showHelp(false);
  return (
    <dialog
      ref={dialog}
      class="help"
      aria-labelledby="help-title"
      onClose={close}
      onClick={(event) => {
        if (event.target === dialog.current) close();
      }}
    >
      <div class="help-body">
        <header>
          <h2 id="help-title">Mouse, fingers and keys</h2>
          <button type="button" class="button" onClick={close}>
            Close
          </button>
        </header>
        <div class="help-columns">
          {ROWS.map(({ title, keys }) => (
            <section key={title}>
              <h3>{title}</h3>
              <dl>
                {keys.map(([key, does]) => (
                  <div key={key}>
                    <dt>{key}</dt>
                    <dd>{does}</dd>
                  </div>
                ))}
              </dl>
            </section>
          ))}
        </div>
      </div>
    </dialog>
  );
}
