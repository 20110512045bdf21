// Removes an item of a list. The focus would be lost with the item, so it moves to the item that takes its place.
import type { JSX } from "preact";
import { Icon } from "./icons";

/** Enabled buttons of the list, without those of nested lists. */
function buttonsOf(list: Element, which: string): HTMLButtonElement[] {
  return [...list.querySelectorAll<HTMLButtonElement>(which)].filter(
    (button) => !button.disabled && button.closest("[data-list]") === list,
  );
}

const removesOf = (list: Element): HTMLButtonElement[] => buttonsOf(list, "[data-removes]");

/** Focuses the next item's remove button, else the previous one's, else the add button. Keeps a focus that moved on. */
function keepFocus(list: Element, index: number, button: Element): void {
  const { activeElement } = document;
  if (activeElement !== document.body && activeElement !== button) return;
  const removes = removesOf(list);
  (removes[Math.min(index, removes.length - 1)] ?? buttonsOf(list, "[data-icon=plus]")[0])?.focus();
}

interface Props {
  label: string;
  onClick: () => void;
  disabled?: boolean;
}

/** Must be inside an element with data-list that holds all items and the add button. */
export function RemoveButton({ label, onClick, disabled }: Props): JSX.Element {
  const remove = (button: HTMLButtonElement): void => {
    const list = button.closest("[data-list]");
    const index = list === null ? 0 : removesOf(list).indexOf(button);
    onClick();
    if (list !== null) requestAnimationFrame(() => keepFocus(list, index, button)); // after the list was updated
  };
  return (
    <button
      type="button"
      class="button icon-button"
      title={label}
      aria-label={label}
      data-removes=""
      disabled={disabled}
      onKeyDown={(event) => {
        if (event.repeat) event.preventDefault(); // a held key would remove all items
      }}
      onClick={(event) => remove(event.currentTarget)}
    >
      <Icon name="close" />
    </button>
  );
}
