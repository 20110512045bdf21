// Gives panels access to the model and the commands.
import { useComputed } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Commands } from "../commands/commands";
import type { FullCamera } from "../model/camera";
import type { Layered } from "../model/layer_order";
import { cameraOf, type Model } from "../model/model";
import { shownTime } from "../model/scalars";

export interface Page {
  model: Model;
  commands: Commands;
}

export const PageContext = createContext<Page | null>(null);

function usePage(): Page {
  const page = useContext(PageContext);
  if (page === null) throw new Error("A panel must be rendered inside PageContext.Provider");
  return page;
}

export const useCommands = (): Commands => usePage().commands;

/** The panel is rendered again when the result of `select` changes. */
export function useModel<V>(select: (model: Model) => V): V {
  const { model } = usePage();
  return useComputed(() => select(model)).value;
}

/** A panel that reads no other member is not rendered again when the camera moves. */
export function useLayers(): Layered {
  return { layers: useModel((model) => model.scene.value?.layers) };
}

export const useShownTime = (): number => useModel((model) => shownTime(model.description.value, model.scene.value));

/** Returns the camera of the shown picture, which may be older than the camera of the scene. */
export function useCamera(): FullCamera | null {
  return useModel((model) => model.shownFrom.value ?? cameraOf(model));
}
