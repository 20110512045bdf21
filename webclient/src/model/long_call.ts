// Text that tells the user the progress of a long call.
import type { Notifications } from "../generated/protocol";
import type { LongCall } from "./state";

type Progress = Notifications["call.progress"];

const STAGES: Record<Progress["stage"], string> = {
  surfaces: "computing the layers",
  waiting: "waiting for another picture",
  drawing: "drawing",
  writing: "writing the file",
};

export function wordsOf({ words, progress }: LongCall): string {
  if (progress === null) return words;
  const { stage, done, of } = progress;
  return `${words}: ${of > 1 ? `layer ${Math.min(done + 1, of)} of ${of}` : STAGES[stage]}`;
}
