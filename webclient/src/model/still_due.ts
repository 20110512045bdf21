// Whether a still picture of full size and quality will replace the shown interactive picture.
import type { PageState } from "./state";

type Seen = Pick<PageState, "connection" | "readout" | "pending" | "revision" | "playing" | "failedRevision">;

/**
 * While a newer scene is pending, the result is false, because an interactive picture of the newer scene comes first.
 */
export function stillDue({ connection, readout, pending, revision, playing, failedRevision }: Seen): boolean {
  const isPreview = readout.stream === "image" && !readout.still;
  const isNewest = !pending && !playing && readout.revision >= revision;
  return connection.kind === "open" && isPreview && isNewest && failedRevision !== readout.revision;
}
