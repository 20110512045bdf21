import type { JSX } from "preact";
import { AXIS_VIEWS, type AxisView } from "../../model/camera";
import type { ExportFormat } from "../../commands/file_commands";
import type { Theme } from "../../model/state";
import { layerNames } from "../../model/layer_names";
import { MINUS } from "../../model/numbers";
import { Check, IconButton, Menu, SelectField } from "../controls/controls";
import { useCommands, useLayers, useModel } from "../context";
import { PictureMenu } from "./picture_menu";
import { ShareMenu } from "./share_menu";
import { ConnectionBadge } from "./connection_badge";
import { useState } from "preact/hooks";

function DatasetSelect(): JSX.Element {
  const commands = useCommands();
  const datasets = useModel((model) => model.datasets.value) ?? [];
  const current = useModel((model) => model.chosen.value ?? model.scene.value?.dataset ?? "");
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
        onChange={(name) => void commands.openDataset(name)}
      />
    </div>
  );
}

function axisLabel(side: AxisView): string {
  return `${side.startsWith("+") ? "+" : MINUS}${side.charAt(1).toUpperCase()}`;
}

function ViewButtons(): JSX.Element {
  const commands = useCommands();
  const disabled = useModel((model) => model.description.value === null);
  return (
    <div class="group views" role="group" aria-label="Views">
      <IconButton
        icon="home"
        label="Show what is drawn"
        keys="R"
        disabled={disabled}
        onClick={() => commands.camera.reset()}
      />
      {AXIS_VIEWS.map((side) => (
        <button
          key={side}
          type="button"
          class="button axis"
          disabled={disabled}
          title={`Look from ${axisLabel(side)}`}
          aria-label={`Look from ${side.startsWith("+") ? "plus" : "minus"} ${side.charAt(1)}`}
          onClick={() => commands.camera.lookFrom(side)}
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
  const commands = useCommands();
  const layers = useLayers();
  const surfaces = Object.entries(layers.layers ?? {}).filter(([, { type }]) =>
    ["iso", "slice", "surface"].includes(type),
  );
  const names = layerNames(layers);
  const [chosen, setChosen] = useState<{ id: string; after: string | null }>({ id: "", after: null });
  const [triangles, setTriangles] = useState(false);
  const touched = useModel((model) => model.touched.value);
  const preferred = chosen.after === touched ? [chosen.id, touched] : [touched];
  const layer = preferred.find((id) => surfaces.some(([other]) => other === id)) ?? surfaces[0]?.[0] ?? "";
  return (
    <Menu icon="download" label="Export a surface" disabled={disabled || surfaces.length === 0}>
      {(close) => (
        <>
          <SelectField
            label="Surface"
            value={layer}
            options={surfaces.map(([id]) => ({ value: id, text: names.get(id) ?? id }))}
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
                  void commands.files.exportSurface(layer, format, triangles);
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
  const commands = useCommands();
  const canUndo = useModel((model) => model.canUndo.value);
  const canRedo = useModel((model) => model.canRedo.value);
  const theme = useModel((model) => model.theme.value);
  const hasScene = useModel((model) => model.scene.value !== null);
  const hasPicture = useModel((model) => model.scene.value !== null && model.fatal.value === null);
  const panelOpen = useModel((model) => model.panelOpen.value);
  return (
    <header class="toolbar">
      <h1 class="wordmark">CIEL</h1>
      <DatasetSelect />
      <div class="group" role="group" aria-label="History">
        <IconButton icon="undo" label="Undo" keys="Ctrl-Z" disabled={!canUndo} onClick={() => commands.undo()} />
        <IconButton icon="redo" label="Redo" keys="Ctrl-Shift-Z" disabled={!canRedo} onClick={() => commands.redo()} />
      </div>
      <ViewButtons />
      <div class="group files" role="group" aria-label="Take away">
        <IconButton
          icon="camera"
          label="Save a picture"
          keys="S"
          disabled={!hasPicture}
          onClick={() => void commands.files.screenshot()}
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
        onClick={() => commands.page.setTheme(NEXT_THEME[theme])}
      />
      <IconButton icon="help" label="Help" keys="?" onClick={() => commands.page.showHelp(true)} />
      <IconButton
        icon="panel"
        label="Side panel"
        keys="P"
        pressed={panelOpen}
        onClick={() => commands.page.togglePanel()}
      />
    </header>
  );
}
