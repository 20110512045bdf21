// The canvas, what lies over it, and the hand on it.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { listenToGestures } from "../camera/gestures";
import { openingDataset } from "../app/opening";
import { isBright, paperAt } from "../display/background";
import { Ahead } from "./ahead";
import { AxesTriad } from "./axes_triad";
import { BoxAxes } from "./box_axes";
import { Captions } from "./captions";
import { useApp, useAppState } from "./context";
import { keepApart } from "./keep_apart";
import { Legends } from "./legend";
import { Busy, ConnectionNotice, FatalNotice, LackingNotice, ToastList } from "./notice";
import { ProbeCard } from "./probe_card";

export function Stage(): JSX.Element {
  const app = useApp();
  const root = useRef<HTMLDivElement>(null);
  const images = useRef<HTMLCanvasElement>(null);
  const geometry = useRef<HTMLCanvasElement>(null);
  const live = useAppState((state) => state.connection.kind === "open");
  const nothing = useAppState((state) => state.fatal !== null);
  const opening = useAppState((state) => openingDataset(state) !== null);
  const background = useAppState(({ scene, fatal }) =>
    scene === null || fatal !== null ? null : (scene.background ?? "dark"),
  );
  const under = background === null ? "" : isBright(background) ? "on-light" : "on-dark"; // without a picture as the page
  useEffect(() => {
    const element = root.current;
    if (element === null || images.current === null || geometry.current === null) return;
    const measure = (): void => app.resized(element.clientWidth, element.clientHeight, window.devicePixelRatio);
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    listenToGestures(element, {
      camera: () => app.actions.camera(),
      size: () => app.size.css,
      zoomed: (camera, factor, x, y) => app.actions.zoomed(camera, factor, x, y),
      move: (camera, gesture) => app.actions.setCamera(camera, gesture),
      newGesture: () => app.editor.newGesture(),
      turns: (x, y) => app.pivot.seek(x, y),
      pivot: (camera) => app.pivot.of(camera),
      click: (x, y) => void app.actions.probe(x, y),
      doubleClick: (x, y) => void app.actions.centreOn(x, y),
    });
    const stage = element.parentElement;
    const end = stage === null ? null : keepApart(stage, (taken) => app.store.set({ taken }));
    void app.start(images.current, geometry.current);
    return () => {
      observer.disconnect();
      end?.();
    };
  }, [app]);
  return (
    <main
      class={`stage ${under} ${live ? "" : "stale"} ${opening ? "opening" : ""}`}
      aria-busy={opening}
      style={
        background === null ? {} : { "--paper-top": paperAt(background, 0), "--paper-bottom": paperAt(background, 1) }
      }
    >
      <div
        class="canvases"
        ref={root}
        tabIndex={0}
        role="application"
        aria-label="3-D view. Drag to turn; press ? for help"
      >
        <canvas ref={images} hidden />
        <canvas ref={geometry} hidden />
      </div>
      {!nothing && !opening && (
        <>
          <Ahead />
          <BoxAxes />
          <AxesTriad />
          <Captions />
          <Legends />
          <ProbeCard />
        </>
      )}
      <Busy />
      {!opening && <LackingNotice />}
      <FatalNotice />
      <ConnectionNotice />
      <ToastList />
    </main>
  );
}
