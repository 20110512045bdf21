// Takes one of several things away. The focus would be lost with it: it goes to what takes its place.
import type { JSX } from "preact";
import { Icon } from "./icons";

/** Not those of lists inside its things. */
function buttonsOf(list: Element, which: string): HTMLButtonElement[] {
  return [...list.querySelectorAll<HTMLButtonElement>(which)].filter(
    (button) => !button.disabled && button.closest("[data-list]") === list,
  );
}

const removesOf = (list: Element): HTMLButtonElement[] => buttonsOf(list, "[data-removes]");

/** To the same button of the next, else of the one before, else to what adds one; a hand that has moved on keeps it. */
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

/** What it is one of stands in an element with data-list, with the button that adds one. */
export function RemoveButton({ label, onClick, disabled }: Props): JSX.Element {
  const remove = (button: HTMLButtonElement): void => {
    const list = button.closest("[data-list]");
    const index = list === null ? 0 : removesOf(list).indexOf(button);
    onClick();
    if (list !== null) requestAnimationFrame(() => keepFocus(list, index, button)); // the list has changed by then
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
        if (event.repeat) event.preventDefault(); // a key that is held would take away all
      }}
      onClick={(event) => remove(event.currentTarget)}
    >
      <Icon name="close" />
    </button>
  );
}
