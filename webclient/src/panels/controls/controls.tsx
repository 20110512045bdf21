// Controls shared by all panels: buttons, fields, sliders, sections and menus.
import type { ComponentChildren, JSX } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { clamp, formatNumber, parseNumber, whyNoNumber } from "../../model/numbers";
import { useCommands } from "../context";
import { Icon, type IconName } from "./icons";

interface IconButtonProps {
  icon: IconName;
  label: string;
  onClick: () => void;
  disabled?: boolean;
  pressed?: boolean;
  text?: string;
  keys?: string;
  help?: string;
}

export function IconButton(props: IconButtonProps): JSX.Element {
  const { icon, label, onClick, disabled, pressed, text, keys, help } = props;
  return (
    <button
      type="button"
      class={text === undefined ? "button icon-button" : "button"}
      title={help ?? (keys === undefined ? label : `${label} (${keys})`)}
      aria-label={label}
      aria-pressed={pressed}
      aria-keyshortcuts={keys?.replaceAll("Ctrl-", "Control+").replaceAll("Shift-", "Shift+")}
      data-icon={icon}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon name={icon} />
      {text}
    </button>
  );
}

interface NumberFieldProps {
  value: number | null;
  label: string;
  help?: string;
  /** Width of the range of possible values. It determines the number of digits. */
  span?: number;
  /** Text shown while the field is not edited. Default: the number itself. */
  shown?: (value: number) => string;
  placeholder?: string;
  step?: number;
  unit?: string;
  /** A typed value outside these limits is clamped, and a message tells the user. */
  limits?: readonly [number, number];
  onChange: (value: number) => void;
}

/** Field for a number. Enter and loss of focus commit the text. Escape or an empty field restores the old value. */
export function NumberField(props: NumberFieldProps): JSX.Element {
  const { value, label, span, placeholder, step, limits, onChange } = props;
  const shown = value === null ? "" : formatNumber(value, span === undefined ? undefined : span / 10);
  const commands = useCommands();
  const [typed, setTyped] = useState<string | null>(null);
  const text = typed ?? (value === null || props.shown === undefined ? shown : props.shown(value));
  const wrong = typed !== null && typed !== "" && parseNumber(typed) === null;
  const within = (number: number): number => (limits === undefined ? number : clamp(number, ...limits));
  const commit = (entered: boolean): void => {
    const parsed = typed === null || typed === shown ? null : parseNumber(typed);
    setTyped(null);
    if (wrong || (entered && typed === "" && shown !== ""))
      commands.tell(`${whyNoNumber(typed)}; ${label} stays ${shown || "empty"}`, "error");
    if (parsed === null) return;
    const kept = within(parsed);
    if (kept !== parsed && limits !== undefined) {
      const [low, high] = limits.map((end) => formatNumber(end));
      commands.tell(`${label} must be from ${low} to ${high}; ${typed} was changed to ${formatNumber(kept)}`);
    }
    if (kept !== value) onChange(kept);
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.key === "Enter") commit(true);
    else if (event.key === "Escape") setTyped(null);
    else if ((event.key === "ArrowUp" || event.key === "ArrowDown") && step !== undefined && value !== null) {
      event.preventDefault();
      const to = within(Number((value + (event.key === "ArrowUp" ? step : -step)).toPrecision(12)));
      if (to !== value) onChange(to);
    } else return;
    event.stopPropagation();
  };
  const input = (
    <input
      class="number-field"
      type="text"
      inputMode="decimal"
      autocomplete="off"
      spellcheck={false}
      aria-label={label}
      aria-invalid={wrong}
      title={props.help ?? (value === null ? label : `${label}: ${value}`)}
      placeholder={placeholder}
      value={text}
      onInput={(event) => setTyped(event.currentTarget.value)}
      onFocus={(event) => {
        if (props.shown !== undefined) setTyped((event.currentTarget.value = shown));
        event.currentTarget.select();
      }}
      onBlur={() => commit(false)}
      onKeyDown={onKeyDown}
    />
  );
  if (props.unit === undefined) return input;
  return (
    <span class="with-unit">
      {input}
      <small aria-hidden="true">{props.unit}</small>
    </span>
  );
}

interface SelectFieldProps {
  label: string;
  value: string;
  options: readonly { value: string; text: string; disabled?: boolean }[];
  onChange: (value: string) => void;
  disabled?: boolean;
  hideLabel?: boolean;
}

/** After a choice by pointer, the field loses the focus, so that the page's keyboard shortcuts work. */
export function SelectField({ label, value, options, onChange, disabled, hideLabel }: SelectFieldProps): JSX.Element {
  const byPointer = useRef(false);
  const select = (
    <select
      aria-label={label}
      value={value}
      disabled={disabled}
      onPointerDown={() => (byPointer.current = true)}
      onBlur={() => (byPointer.current = false)}
      onKeyDown={(event) => {
        if (event.key === "Escape") byPointer.current = false;
      }}
      onChange={(event) => {
        const select = event.currentTarget;
        onChange(select.value);
        if (byPointer.current) select.blur();
      }}
    >
      {options.map((option) => (
        <option key={option.value} value={option.value} disabled={option.disabled}>
          {option.text}
        </option>
      ))}
    </select>
  );
  if (hideLabel === true) return select;
  return (
    <label class="field">
      <span>{label}</span>
      {select}
    </label>
  );
}

interface CheckProps {
  label: string;
  checked: boolean;
  onChange: (checked: boolean) => void;
  detail?: string;
}

export function Check({ label, checked, onChange, detail }: CheckProps): JSX.Element {
  return (
    <label class="check">
      <input type="checkbox" checked={checked} onChange={(event) => onChange(event.currentTarget.checked)} />
      <span>{label}</span>
      {detail !== undefined && <small>{detail}</small>}
    </label>
  );
}

interface SliderProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  text?: string;
  disabled?: boolean;
  /** Called for each move of the slider. `gesture` is the same name from press to release. */
  onChange: (value: number, gesture: string) => void;
  newGesture: () => string;
}

export function Slider({
  label,
  value,
  min,
  max,
  step,
  text,
  disabled,
  onChange,
  newGesture,
}: SliderProps): JSX.Element {
  const gesture = useRef("");
  const begin = (): void => void (gesture.current = newGesture());
  return (
    <input
      class="slider"
      type="range"
      aria-label={label}
      aria-valuetext={text}
      min={min}
      max={max}
      step={step}
      value={value}
      disabled={disabled}
      onPointerDown={begin}
      onKeyDown={(event) => {
        if (!event.repeat) begin();
      }}
      onInput={(event) => {
        if (gesture.current === "") begin();
        onChange(Number(event.currentTarget.value), gesture.current);
      }}
    />
  );
}

interface SectionProps {
  title: string;
  children: ComponentChildren;
  action?: JSX.Element | null;
  /** Shown even if the section is folded. */
  summary?: JSX.Element;
  open?: boolean;
}

export function Section({ title, children, action, summary, open = true }: SectionProps): JSX.Element {
  const [isOpen, setOpen] = useState(open);
  return (
    <section class="section" data-list="">
      <header>
        <button type="button" class="section-title" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
          <Icon name="chevron" />
          <h2>{title}</h2>
        </button>
        {action}
      </header>
      {summary}
      {isOpen && <div class="section-body">{children}</div>}
    </section>
  );
}

interface MenuProps {
  icon: IconName;
  label: string;
  text?: string;
  disabled?: boolean;
  children: (close: () => void) => ComponentChildren;
}

export function Menu({ icon, label, text, disabled, children }: MenuProps): JSX.Element {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!isOpen) return;
    const outside = (event: PointerEvent): void => {
      if (!(root.current?.contains(event.target as Node) ?? false)) setOpen(false);
    };
    document.addEventListener("pointerdown", outside);
    return () => document.removeEventListener("pointerdown", outside);
  }, [isOpen]);
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.key !== "Escape" || !isOpen) return;
    event.stopPropagation();
    setOpen(false);
    root.current?.querySelector("button")?.focus();
  };
  return (
    <div class="menu" ref={root} onKeyDown={onKeyDown}>
      <button
        type="button"
        class={text === undefined ? "button icon-button" : "button"}
        title={label}
        aria-label={label}
        aria-expanded={isOpen}
        aria-haspopup="true"
        disabled={disabled}
        onClick={() => setOpen(!isOpen)}
      >
        <Icon name={icon} />
        {text}
      </button>
      {isOpen && <div class="menu-body">{children(() => setOpen(false))}</div>}
    </div>
  );
}
