// What the server's word does to the page.
import type { Notifications, Scene } from "../generated/protocol";
import { wordsFor, type SessionHost } from "../session/session";
import type { App } from "./app";
import { describeDatasets, listDatasets } from "./datasets";
import { firstScene } from "./first_scene";
import { openingDataset } from "./opening";
import { emptyReadout } from "./state";

type Handlers = { [N in keyof Notifications]: (params: Notifications[N]) => void };

const NOTHING = "The server offers no dataset that can be opened. Start it with one: ciel serve NAME.ciel";

function removePicture(app: App): void {
  app.viewport?.clear();
  const { roundTripMs } = app.store.get().readout;
  app.store.set({ shownDataset: null, readout: { ...emptyReadout, roundTripMs } });
}

export function sessionHost(app: App): SessionHost {
  const handlers = notificationHandlers(app);
  return {
    firstScene: async (call) => {
      const background = app.actions.themeBackground();
      const scene = await firstScene(call, {
        session: app.tab.id,
        rejoin: app.tab.known,
        link: app.links.first,
        size: app.size,
        background,
      });
      app.store.set({ fatal: scene === null ? NOTHING : null });
      return scene;
    },
    viewSize: () => ({ ...app.size.pixels(), pixel_ratio: app.size.pixelRatio }),
    stream: () => app.streams.current(),
    viewOpening: () => app.presenter?.expect(),
    viewOpened: (view) => app.presenter?.show(view),
    opened: ({ revision, scene }) => {
      app.latency.reset();
      app.scenes.clear();
      app.histograms.clear();
      // Revisions of the session before, if the server forgot it, mean nothing here.
      app.store.set({ fatal: null, revision, readout: { ...app.store.get().readout, revision: 0 } });
      app.taken(revision, scene);
      void describeDatasets(app, true);
    },
    refused: (error) => {
      removePicture(app); // which is of a session that is no more
      app.store.set({
        fatal: wordsFor(error),
        description: null,
        probe: null,
        lacking: [],
        empty: [],
        missing: [],
      });
      void listDatasets(app);
    },
    connection: (connection) => {
      app.store.set({ connection });
      if (connection.kind === "waiting") {
        app.player.stop();
        void app.access.explain();
      }
      if (connection.kind !== "open") return;
      app.access.opened();
      app.store.set({ draining: false, fatal: null, lacking: [], empty: [], missing: [] });
      void listDatasets(app);
      void app.session.call("server.info", {}).then(
        (server) => app.store.set({ server }),
        (error: unknown) => app.fail(error),
      );
    },
    roundTrip: (roundTripMs) => {
      app.store.set({ readout: { ...app.store.get().readout, roundTripMs } });
      app.streams.reconsider();
    },
    binary: (message) => app.presenter?.receive(message),
    notified: (name, params) => {
      if (name in handlers) handlers[name](params as never);
    },
    failed: (error) => app.fail(error),
  };
}

function notificationHandlers(app: App): Handlers {
  const heard = ({ revision, scene }: { revision: number; scene: Scene }): void => {
    app.store.set({ revision });
    app.taken(revision, scene);
    app.editor.overheard(scene);
  };
  return {
    "dataset.changed": ({ dataset, times }) => {
      const { description } = app.store.get();
      void listDatasets(app); // it may have become one that cannot be opened, or can be again
      if (description?.name !== dataset) return;
      const more = times === undefined ? 0 : times.length - description.times.length;
      const appended = more > 0 && description.times.every((time, step) => time === times?.[step]);
      if (appended) app.toasts.show(`${more} more time ${more === 1 ? "step has" : "steps have"} arrived`);
      else app.histograms.clear(); // another dataset of the name; an appended one keeps the steps that it had
      void describeDatasets(app, true);
    },
    "scene.changed": ({ session, revision, scene }) => {
      if (session !== app.tab.id) return;
      if (scene === undefined) {
        void app.session.call("scene.get", { session }).then(heard, (error: unknown) => app.fail(error));
      } else heard({ revision, scene });
    },
    "view.failed": ({ message, revision }) => {
      app.player.stop();
      if (openingDataset(app.store.get()) !== null) removePicture(app); // which is of another dataset
      app.store.set({ failedRevision: revision });
      app.toasts.show(message, "error");
    },
    "view.lacking": ({ sentences, empty, missing }) => app.store.set({ lacking: sentences, empty, missing }),
    "append.refused": ({ reason }) => app.toasts.show(reason, "error"),
    "server.draining": () => app.store.set({ draining: true }),
  };
}
