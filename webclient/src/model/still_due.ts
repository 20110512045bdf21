// Whether a still will replace the shown preview. The server sends previews while the scene changes, and afterwards a
// still.
import type { PageState } from "./state";

type Seen = Pick<PageState, "connection" | "readout" | "pending" | "revision" | "playing" | "failedRevision">;

/**
 * Whether the still of the shown preview is due. False while a newer scene is pending, since its preview comes first,
 * and if the server failed to draw this revision.
 */
export function stillDue({ connection, readout, pending, revision, playing, failedRevision }: Seen): boolean {
  const isPreview = readout.stream === "image" && !readout.still;
  const isNewest = !pending && !playing && readout.revision >= revision;
  return connection.kind === "open" && isPreview && isNewest && failedRevision !== readout.revision;
}
