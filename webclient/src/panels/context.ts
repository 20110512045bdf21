import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { FullCamera } from "../camera/camera";
import type { App } from "../app/app";
import type { AppState } from "../app/state";
import { useStore } from "../app/store";

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (app === null) throw new Error("A panel stands outside the page");
  return app;
}

export const useAppState = <V>(select: (state: Readonly<AppState>) => V): V => useStore(useApp().store, select);

/** The camera of what is seen, which is not always the newest. */
export function useCamera(): FullCamera | null {
  const { actions } = useApp();
  useAppState((state) => state.scene?.camera);
  useAppState((state) => state.seenFrom);
  return useAppState((state) => state.shownFrom) ?? actions.camera();
}
