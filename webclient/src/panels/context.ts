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
  if (page === null) throw new Error("A panel stands outside the page");
  return page;
}

export const useCommands = (): Commands => usePage().commands;

/** Returns the result of `select`. The panel is rendered again when this result changes. */
export function useModel<V>(select: (model: Model) => V): V {
  const { model } = usePage();
  return useComputed(() => select(model)).value;
}

/** Layers of the scene. A panel that needs no other member is not rendered again when the camera moves. */
export function useLayers(): Layered {
  return { layers: useModel((model) => model.scene.value?.layers) };
}

/** Time step of the scene. */
export const useShownTime = (): number => useModel((model) => shownTime(model.description.value, model.scene.value));

/** Camera of the shown picture. It may be older than that of the scene. */
export function useCamera(): FullCamera | null {
  return useModel((model) => model.shownFrom.value ?? cameraOf(model));
}
