import type { JSX } from "preact";
import { AXIS_VIEWS, type AxisView } from "../camera/camera";
import type { ExportFormat } from "../app/actions";
import type { Theme } from "../app/state";
import { layerNames } from "../scene/layer_names";
import { MINUS } from "../scene/numbers";
import { Check, IconButton, Menu, SelectField } from "./controls";
import { useApp, useAppState } from "./context";
import { PictureMenu } from "./picture_menu";
import { ShareMenu } from "./share_menu";
import { ConnectionBadge } from "./connection_badge";
import { useState } from "preact/hooks";

function DatasetSelect(): JSX.Element {
  const { actions } = useApp();
  const datasets = useAppState((state) => state.datasets) ?? [];
  const current = useAppState((state) => state.chosen ?? state.scene?.dataset ?? "");
  const options = datasets.map(({ name, problem }) => ({
    value: name,
    text: problem === "" ? name : `${name}: ${problem}`,
    disabled: problem !== "",
  }));
  if (!datasets.some(({ name }) => name === current)) {
    options.unshift({ value: current, text: current === "" ? "No dataset" : current, disabled: current !== "" });
  }
  return (
    <div class="dataset-select">
      <SelectField
        label="Dataset"
        hideLabel
        value={current}
        options={options}
        onChange={(name) => void actions.openDataset(name)}
      />
    </div>
  );
}

function axisLabel(side: AxisView): string {
  return `${side.startsWith("+") ? "+" : MINUS}${side.charAt(1).toUpperCase()}`;
}

function ViewButtons(): JSX.Element {
  const { actions } = useApp();
  const disabled = useAppState((state) => state.description === null);
  return (
    <div class="group views" role="group" aria-label="Views">
      <IconButton
        icon="home"
        label="Show what is drawn"
        keys="R"
        disabled={disabled}
        onClick={() => actions.resetView()}
      />
      {AXIS_VIEWS.map((side) => (
        <button
          key={side}
          type="button"
          class="button axis"
          disabled={disabled}
          title={`Look from ${axisLabel(side)}`}
          aria-label={`Look from ${side.startsWith("+") ? "plus" : "minus"} ${side.charAt(1)}`}
          onClick={() => actions.lookFrom(side)}
        >
          {axisLabel(side)}
        </button>
      ))}
    </div>
  );
}

const FORMATS: { format: ExportFormat; text: string }[] = [
  { format: "ply", text: "PLY" },
  { format: "stl", text: "STL" },
  { format: "vtp", text: "VTP" },
];

function ExportMenu({ disabled }: { disabled: boolean }): JSX.Element {
  const { actions } = useApp();
  const scene = useAppState((state) => state.scene);
  const layers = Object.entries(scene?.layers ?? {}).filter(([, { type }]) =>
    ["iso", "slice", "surface"].includes(type),
  );
  const names = layerNames(scene);
  const [chosen, setChosen] = useState<{ id: string; after: string | null }>({ id: "", after: null });
  const [triangles, setTriangles] = useState(false);
  const touched = useAppState((state) => state.touched);
  const preferred = chosen.after === touched ? [chosen.id, touched] : [touched];
  const layer = preferred.find((id) => layers.some(([other]) => other === id)) ?? layers[0]?.[0] ?? "";
  return (
    <Menu icon="download" label="Export a surface" disabled={disabled || layers.length === 0}>
      {(close) => (
        <>
          <SelectField
            label="Surface"
            value={layer}
            options={layers.map(([id]) => ({ value: id, text: names.get(id) ?? id }))}
            onChange={(id) => setChosen({ id, after: touched })}
          />
          <Check label="Triangles only" checked={triangles} onChange={setTriangles} />
          <div class="row">
            {FORMATS.map(({ format, text }) => (
              <button
                key={format}
                type="button"
                class="button"
                onClick={() => {
                  close();
                  void actions.exportSurface(layer, format, triangles);
                }}
              >
                {text}
              </button>
            ))}
          </div>
        </>
      )}
    </Menu>
  );
}

const NEXT_THEME: Record<Theme, Theme> = { system: "light", light: "dark", dark: "system" };
const THEME_WORDS: Record<Theme, string> = { system: "as the system", light: "light", dark: "dark" };

export function Toolbar(): JSX.Element {
  const { actions, store } = useApp();
  const canUndo = useAppState((state) => state.canUndo);
  const canRedo = useAppState((state) => state.canRedo);
  const theme = useAppState((state) => state.theme);
  const hasScene = useAppState((state) => state.scene !== null);
  const hasPicture = useAppState((state) => state.scene !== null && state.fatal === null);
  const panelOpen = useAppState((state) => state.panelOpen);
  return (
    <header class="toolbar">
      <h1 class="wordmark">CIEL</h1>
      <DatasetSelect />
      <div class="group" role="group" aria-label="History">
        <IconButton icon="undo" label="Undo" keys="Ctrl-Z" disabled={!canUndo} onClick={() => actions.undo()} />
        <IconButton icon="redo" label="Redo" keys="Ctrl-Shift-Z" disabled={!canRedo} onClick={() => actions.redo()} />
      </div>
      <ViewButtons />
      <div class="group files" role="group" aria-label="Take away">
        <IconButton
          icon="camera"
          label="Save a picture"
          keys="S"
          disabled={!hasPicture}
          onClick={() => void actions.screenshot()}
        />
        <PictureMenu disabled={!hasPicture} />
        <ExportMenu disabled={!hasPicture} />
        <ShareMenu disabled={!hasScene} />
      </div>
      <span class="spring" />
      <ConnectionBadge />
      <IconButton
        icon="theme"
        label={`Theme: ${THEME_WORDS[theme]}`}
        onClick={() => actions.setTheme(NEXT_THEME[theme])}
      />
      <IconButton icon="help" label="Help" keys="?" onClick={() => store.set({ helpOpen: true })} />
      <IconButton
        icon="panel"
        label="Side panel"
        keys="P"
        pressed={panelOpen}
        onClick={() => store.set({ panelOpen: !panelOpen })}
      />
    </header>
  );
}
