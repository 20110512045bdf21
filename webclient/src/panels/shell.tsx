import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { listenToDrops } from "../app/dropped";
import { handleKey } from "../app/keys";
import { isDark } from "../app/preferences";
import { BoundarySection } from "./boundary_section";
import { CameraSection } from "./camera_section";
import { ClipSection } from "./clip_section";
import { useApp, useAppState } from "./context";
import { DatasetSection } from "./dataset_section";
import { Help } from "./help";
import { IsoSection } from "./iso_section";
import { LayersSection } from "./layers_section";
import { LightingSection } from "./lighting_section";
import { LinesAndPointsSection } from "./lines_and_points_section";
import { SlicesSection } from "./slices_section";
import { Stage } from "./stage";
import { StatusBar } from "./status_bar";
import { TimeBar } from "./time_bar";
import { Toolbar } from "./toolbar";
import { ViewSection } from "./view_section";
import { VolumeSection } from "./volume_section";

function useTheme(): void {
  const { actions } = useApp();
  const theme = useAppState((state) => state.theme);
  useEffect(() => {
    const apply = (): void => void (document.documentElement.dataset.theme = isDark(theme) ? "dark" : "light");
    apply();
    const system = matchMedia("(prefers-color-scheme: dark)");
    const turned = (): void => {
      apply();
      if (theme === "system") actions.matchBackground();
    };
    system.addEventListener("change", turned);
    return () => system.removeEventListener("change", turned);
  }, [theme]);
}

export function Shell(): JSX.Element {
  const app = useApp();
  const panelOpen = useAppState((state) => state.panelOpen);
  const nothing = useAppState((state) => state.fatal !== null);
  const chosen = useAppState((state) => state.chosen);
  const title = useAppState((state) => state.scene?.dataset);
  useTheme();
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => handleKey(app, event);
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, [app]);
  useEffect(() => listenToDrops((sentence) => app.toasts.show(sentence)), [app]);
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
