// What time play needs of the page.
import { nearestStep } from "../scene/scalars";
import type { PlayerHost } from "../session/player";
import type { App } from "./app";

export function playerHost(app: App): PlayerHost {
  const times = (): readonly number[] => app.store.get().description?.times ?? [];
  return {
    times,
    shownStep: () => nearestStep(times(), app.editor.scene?.time),
    show: (step, gesture) => {
      const time = times()[step];
      if (time !== undefined) app.editor.change({ time }, gesture);
    },
    newGesture: () => app.editor.newGesture(),
    rate: () => app.store.get().playRate,
    loop: () => app.store.get().loop,
    changed: (playing) => app.store.set({ playing }),
  };
}
