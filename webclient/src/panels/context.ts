// Gives panels access to the model and the commands.
import { useComputed } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Commands } from "../commands/commands";
import type { ViewCamera } from "../model/camera";
import type { Layered } from "../model/layer_order";
import { cameraOf, type Model } from "../model/model";
import { shownTime } from "../model/scalars";

export interface ModelAndCommands {
  model: Model;
  commands: Commands;
}

export const PageContext = createContext<ModelAndCommands | null>(null);

function usePageContext(): ModelAndCommands {
  const page = useContext(PageContext);
  if (page === null) throw new Error("A panel must be rendered inside PageContext.Provider");
  return page;
}

export const useCommands = (): Commands => usePageContext().commands;

/** The panel is rendered again when the result of `select` changes. */
export function useModel<V>(select: (model: Model) => V): V {
  const { model } = usePageContext();
  return useComputed(() => select(model)).value;
}

/** Selects only the layers, so that a move of the camera does not render the panel again. */
export function useLayers(): Layered {
  return { layers: useModel((model) => model.scene.value?.layers) };
}

export const useShownTime = (): number => useModel((model) => shownTime(model.description.value, model.scene.value));

/** Returns the camera of the shown picture, which may be older than the camera of the scene. */
export function useCamera(): ViewCamera | null {
  return useModel((model) => model.shownFrom.value ?? cameraOf(model));
}
