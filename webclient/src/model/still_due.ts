// Whether the server owes the full picture of what is seen: it sends a preview at once and the still when it is drawn.
import type { PageState } from "./state";

type Seen = Pick<PageState, "connection" | "readout" | "pending" | "revision" | "playing" | "failedRevision">;

/** False while a newer scene is on its way, of which a preview comes first, and where the server has given up. */
export function stillDue({ connection, readout, pending, revision, playing, failedRevision }: Seen): boolean {
  const isPreview = readout.stream === "image" && !readout.still;
  const isNewest = !pending && !playing && readout.revision >= revision;
  return connection.kind === "open" && isPreview && isNewest && failedRevision !== readout.revision;
}
