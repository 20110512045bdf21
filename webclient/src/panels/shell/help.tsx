import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { useCommands, useModel } from "../context";

const ROWS: { title: string; keys: [string, string][] }[] = [
  {
    title: "Mouse and fingers",
    keys: [
      ["Drag", "Turn about what is under the cursor"],
      ["Shift-drag, right or middle drag", "Move sideways"],
      ["Ctrl-drag", "Roll"],
      ["Wheel, pinch", "Zoom to the cursor"],
      ["Click", "Read the values there, and name the patch"],
      ["Double-click", "Centre there"],
    ],
  },
  {
    title: "Keys",
    keys: [
      ["Arrow keys", "Turn; with Shift move"],
      ["+ and -", "Zoom"],
      ["R", "Show what is drawn; with Shift the whole box"],
      ["X, Y, Z", "Look along an axis; with Shift from the other side"],
      ["O", "Parallel or perspective"],
      ["Space", "Play or pause"],
      [", and .", "Step back and on"],
      ["Ctrl-Z, Ctrl-Shift-Z", "Undo, redo"],
      ["S", "Save a picture"],
      ["L", "Copy a link"],
      ["P", "Side panel"],
      ["?", "This help"],
      ["Esc", "Close"],
    ],
  },
  {
    title: "On an iso-value",
    keys: [
      ["Arrow keys", "Small steps; with Shift large ones"],
      ["Page up, page down", "A tenth of the range"],
      ["Home, End", "Lowest, highest"],
    ],
  },
  {
    title: "On the opacity curve of a volume",
    keys: [
      ["Click beside the points", "One more point"],
      ["Drag, arrow keys", "Move a point; with Shift in large steps"],
      ["Delete, double click", "Take a point away"],
    ],
  },
  {
    title: "On a legend",
    keys: [
      ["A number at an end", "Type another: the ends are then held"],
      ["The pin", "The same range at every step: the whole dataset's"],
      ["The arrow in a circle", "The range of each step again"],
      ["this step, all steps, held", "Whose lowest and highest value the ends are"],
      ["A triangle at an end", "The color of values beyond it"],
    ],
  },
  {
    title: "In the list of layers",
    keys: [
      ["Drag a row", "Another order"],
      ["The arrows of a row", "The same, by keys and fingers"],
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
