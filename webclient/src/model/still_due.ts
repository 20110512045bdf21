// Whether a still picture will replace the shown picture. The server sends interactive pictures while the scene
// changes, and afterwards one still picture, which has the full size and quality.
import type { PageState } from "./state";

type Seen = Pick<PageState, "connection" | "readout" | "pending" | "revision" | "playing" | "failedRevision">;

/**
 * Whether the still picture of the shown revision is due. It is not due while a newer scene is pending, because the
 * interactive picture of the newer scene comes first. It is not due if the server failed to draw this revision.
 */
export function stillDue({ connection, readout, pending, revision, playing, failedRevision }: Seen): boolean {
  const isPreview = readout.stream === "image" && !readout.still;
  const isNewest = !pending && !playing && readout.revision >= revision;
  return connection.kind === "open" && isPreview && isNewest && failedRevision !== readout.revision;
}
