// Text that tells the user the progress of a long call.
import type { Notifications } from "../generated/protocol";
import type { LongCall } from "./state";

type Progress = Notifications["call.progress"];

const STAGES: Record<Progress["stage"], string> = {
  reading: "reading the step from its source",
  surfaces: "computing the layers",
  measuring: "measuring",
  waiting: "waiting for another picture",
  drawing: "drawing",
  writing: "writing the file",
};

export function wordsOf({ words, progress }: LongCall): string {
  if (progress === null) return words;
  const { stage, done, of } = progress;
  return `${words}: ${stage === "surfaces" && of > 1 ? `layer ${Math.min(done + 1, of)} of ${of}` : STAGES[stage]}`;
}
