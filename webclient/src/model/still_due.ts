// Whether the still of the shown preview is due: the server sends a preview at once and the still when it is drawn.
import type { PageState } from "./state";

type Seen = Pick<PageState, "connection" | "readout" | "pending" | "revision" | "playing" | "failedRevision">;

/** False while a newer scene is pending, because its preview comes first, and if the server failed to draw. */
export function stillDue({ connection, readout, pending, revision, playing, failedRevision }: Seen): boolean {
  const isPreview = readout.stream === "image" && !readout.still;
  const isNewest = !pending && !playing && readout.revision >= revision;
  return connection.kind === "open" && isPreview && isNewest && failedRevision !== readout.revision;
}
