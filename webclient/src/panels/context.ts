// Context of the panels: the model and the commands.
import { useComputed } from "@preact/signals";
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Commands } from "../commands/commands";
import type { FullCamera } from "../model/camera";
import { cameraOf, type Model } from "../model/model";

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

/** Renders the panel again when the result of `select` changes. */
export function useModel<V>(select: (model: Model) => V): V {
  const { model } = usePage();
  return useComputed(() => select(model)).value;
}

/** The camera of the shown picture, which may be older than the scene's. */
export function useCamera(): FullCamera | null {
  return useModel((model) => model.shownFrom.value ?? cameraOf(model));
}
