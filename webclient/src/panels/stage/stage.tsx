// The canvases, the overlays over the canvases, and the input events of the canvases.
import type { JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { DEFAULTS } from "../../generated/protocol";
import { openingIn } from "../../model/model";
import { isBright } from "../../model/background";
import { Ahead } from "./ahead";
import { Annotations } from "./annotations";
import { useCommands, useModel } from "../context";
import { Texts } from "./texts";
import { Busy, ConnectionNotice, FatalNotice, LackingNotice, ToastList } from "./notice";
import { ProbeCard } from "./probe_card";

export function Stage(): JSX.Element {
  const commands = useCommands();
  const root = useRef<HTMLDivElement>(null);
  const images = useRef<HTMLCanvasElement>(null);
  const geometry = useRef<HTMLCanvasElement>(null);
  const live = useModel((model) => model.connection.value.kind === "open");
  const nothing = useModel((model) => model.fatal.value !== null);
  const opening = useModel((model) => openingIn(model) !== null);
  const background = useModel(({ scene, fatal }) =>
    scene.value === null || fatal.value !== null ? null : (scene.value.background ?? DEFAULTS.Scene.background),
  );
  const under = background === null ? "" : isBright(background) ? "on-light" : "on-dark"; // "" is the page's theme
  useEffect(() => {
    const element = root.current;
    if (element === null || images.current === null || geometry.current === null) return;
    const measure = (): void =>
      commands.page.resized(element.clientWidth, element.clientHeight, window.devicePixelRatio);
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    commands.listenTo(element);
    void commands.page.attach(images.current, geometry.current);
    return () => observer.disconnect();
  }, [commands]);
  return (
    <main class={`stage ${under} ${live ? "" : "stale"} ${opening ? "opening" : ""}`} aria-busy={opening}>
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
          <Annotations />
          <Texts />
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
