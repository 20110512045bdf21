// Applies the server's answers and notifications to the page's state.
import type { Notifications, Scene } from "../generated/protocol";
import { wordsFor, type SessionHost } from "./session";
import { describeDataset, listDatasets } from "./datasets";
import { firstScene } from "./first_scene";
import { openingIn, update } from "../model/model";
import { emptyReadout, type ConnectionState } from "../model/state";
import { showToast } from "../model/toasts";
import type { Core } from "./core";

type Handlers = { [N in keyof Notifications]: (params: Notifications[N]) => void };

const NOTHING = "The server has no dataset that can be opened. Start the server with a dataset: ciel serve NAME.ciel";

function removePicture(server: Core): void {
  server.page.clearPicture();
  const { roundTripMs } = server.model.readout.peek();
  update(server.model, { shownScene: null, readout: { ...emptyReadout, roundTripMs } });
}

function heardOfConnection(server: Core, connection: ConnectionState): void {
  update(server.model, { connection });
  if (connection.kind === "waiting") {
    server.page.stopPlaying();
    void server.entry.explain();
  }
  if (connection.kind !== "open") return;
  server.entry.opened();
  update(server.model, { draining: false, fatal: null, lacking: [], empty: [], missing: [] });
  void listDatasets(server);
  void server.session.call("server.info", {}).then(
    (info) => update(server.model, { server: info }),
    (error: unknown) => server.fail(error),
  );
}

export function sessionHost(server: Core): SessionHost {
  const handlers = notificationHandlers(server);
  return {
    firstScene: async (call) => {
      const background = server.page.background();
      const scene = await firstScene(call, {
        session: server.tab.id,
        rejoin: server.tab.known,
        link: server.page.link(),
        size: server.size,
        background,
      });
      update(server.model, { fatal: scene === null ? NOTHING : null });
      return scene;
    },
    viewSize: () => ({ ...server.size.pixels(), pixel_ratio: server.size.pixelRatio }),
    stream: () => server.streams.wanted(),
    viewOpening: () => server.page.frames()?.expect(),
    viewOpened: (view) => server.page.frames()?.show(view),
    opened: ({ revision, scene }) => {
      server.latency.reset();
      server.scenes.clear();
      server.histograms.clear();
      // A restarted server counts revisions from the start, so the readout's revision is reset.
      update(server.model, { fatal: null, revision, readout: { ...server.model.readout.peek(), revision: 0 } });
      server.taken(revision, scene);
      void describeDataset(server, true);
    },
    refused: (error) => {
      removePicture(server); // the picture shows a session that no longer exists
      update(server.model, {
        fatal: wordsFor(error),
        description: null,
        probe: null,
        lacking: [],
        empty: [],
        missing: [],
      });
      void listDatasets(server);
    },
    connection: (connection) => heardOfConnection(server, connection),
    roundTrip: (roundTripMs) => {
      update(server.model, { readout: { ...server.model.readout.peek(), roundTripMs } });
      server.streams.reconsider();
    },
    binary: (message) => server.page.frames()?.receive(message),
    notified: (name, params) => {
      if (name in handlers) handlers[name](params as never);
    },
    failed: (error) => server.fail(error),
  };
}

function notificationHandlers(server: Core): Handlers {
  const heard = ({ revision, scene }: { revision: number; scene: Scene }): void => {
    update(server.model, { revision });
    server.taken(revision, scene);
    server.editor.overheard(scene);
  };
  return {
    "dataset.changed": ({ dataset, times }) => {
      const description = server.model.description.peek();
      void listDatasets(server); // this dataset may have become usable or unusable
      if (description?.name !== dataset) return;
      const more = times === undefined ? 0 : times.length - description.times.length;
      const appended = more > 0 && description.times.every((time, step) => time === times?.[step]);
      if (appended) showToast(server.model, `${more} more time ${more === 1 ? "step has" : "steps have"} arrived`);
      else server.histograms.clear(); // only an append keeps the values of earlier steps
      void describeDataset(server, true);
    },
    "scene.changed": ({ session, revision, scene }) => {
      if (session !== server.tab.id) return;
      if (scene === undefined) {
        void server.session.call("scene.get", { session }).then(heard, (error: unknown) => server.fail(error));
      } else heard({ revision, scene });
    },
    "view.failed": ({ message, revision }) => {
      server.page.stopPlaying();
      if (openingIn(server.model) !== null) removePicture(server); // the picture shows the previous dataset
      update(server.model, { failedRevision: revision });
      showToast(server.model, message, "error");
    },
    "view.lacking": ({ sentences, empty, missing }) => update(server.model, { lacking: sentences, empty, missing }),
    "call.progress": (progress) => {
      const call = server.model.longCall.peek();
      if (call?.name === progress.progress) update(server.model, { longCall: { ...call, progress } });
    },
    "append.refused": ({ reason }) => showToast(server.model, reason, "error"),
    "server.draining": () => update(server.model, { draining: true }),
  };
}
