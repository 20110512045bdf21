import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { listenToDrops } from "../../commands/dropped";
import { handleKey } from "../../commands/keys";
import { isDark } from "../../commands/preferences";
import { BoundarySection } from "../layers/boundary_section";
import { CameraSection } from "../look/camera_section";
import { ClipSection } from "../layers/clip_section";
import { useCommands, useModel } from "../context";
import { DatasetSection } from "../layers/dataset_section";
import { Help } from "./help";
import { IsoSection } from "../layers/iso_section";
import { LayersSection } from "../layers/layers_section";
import { LightingSection } from "../look/lighting_section";
import { LinesAndPointsSection } from "../layers/lines_and_points_section";
import { SlicesSection } from "../layers/slices_section";
import { Stage } from "../stage/stage";
import { StatusBar } from "./status_bar";
import { TimeBar } from "../time/time_bar";
import { Toolbar } from "./toolbar";
import { ViewSection } from "../look/view_section";
import { VolumeSection } from "../volume/volume_section";

function useTheme(): void {
  const commands = useCommands();
  const theme = useModel((model) => model.theme.value);
  useEffect(() => {
    const apply = (): void => void (document.documentElement.dataset.theme = isDark(theme) ? "dark" : "light");
    apply();
    const system = matchMedia("(prefers-color-scheme: dark)");
    const turned = (): void => {
      apply();
      if (theme === "system") commands.page.matchBackground();
    };
    system.addEventListener("change", turned);
    return () => system.removeEventListener("change", turned);
  }, [theme]);
}

export function Shell(): JSX.Element {
  const commands = useCommands();
  const panelOpen = useModel((model) => model.panelOpen.value);
  const nothing = useModel((model) => model.fatal.value !== null);
  const chosen = useModel((model) => model.chosen.value);
  const title = useModel((model) => model.scene.value?.dataset);
  useTheme();
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => handleKey(commands, event);
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, [commands]);
  useEffect(() => listenToDrops((sentence) => commands.tell(sentence)), [commands]);
  useEffect(() => void (document.title = title === undefined ? "CIEL" : `${title} - CIEL`), [title]);
  return (
    <div class={panelOpen ? "shell" : "shell no-panel"}>
      <Toolbar />
      <Stage />
      <TimeBar />
      {panelOpen && (
        <aside class="side-panel" aria-label="Scene">
          {chosen !== null && <p class="opening-hint hint">{`Opening ${chosen}`}</p>}
          {!nothing && (
            <div hidden={chosen !== null}>
              <DatasetSection />
              <LayersSection />
              <IsoSection />
              <SlicesSection />
              <VolumeSection />
              <BoundarySection />
              <LinesAndPointsSection />
              <ClipSection />
              <CameraSection />
              <LightingSection />
              <ViewSection />
            </div>
          )}
        </aside>
      )}
      <StatusBar />
      <Help />
    </div>
  );
}
