import type { JSX } from "preact";
import { formatNumber } from "../../model/numbers";
import { nearestStep } from "../../model/scalars";
import { IconButton, SelectField, Slider } from "../controls/controls";
import { useCommands, useModel } from "../context";

const NO_TIMES: readonly number[] = [];
const RATES = [2, 5, 10, 20, 60];

function Steps({ step, last }: { step: number; last: number }): JSX.Element {
  const commands = useCommands();
  const playing = useModel((model) => model.playing.value);
  return (
    <>
      <IconButton
        icon="previous"
        label="Step back"
        keys=","
        disabled={step === 0}
        onClick={() => commands.time.stepBy(-1)}
      />
      <IconButton
        icon={playing ? "pause" : "play"}
        label={playing ? "Pause" : "Play"}
        keys="Space"
        pressed={playing}
        onClick={() => commands.time.togglePlay()}
      />
      <IconButton
        icon="next"
        label="Step on"
        keys="."
        disabled={step === last}
        onClick={() => commands.time.stepBy(1)}
      />
    </>
  );
}

function Pace(): JSX.Element {
  const commands = useCommands();
  const loop = useModel((model) => model.loop.value);
  const rate = useModel((model) => model.playRate.value);
  return (
    <>
      <IconButton
        icon="loop"
        label="Start again at the end"
        pressed={loop}
        onClick={() => commands.time.setLoop(!loop)}
      />
      <SelectField
        label="Steps a second, at most"
        hideLabel
        value={String(rate)}
        options={RATES.map((value) => ({ value: String(value), text: `${value} / s` }))}
        onChange={(value) => commands.time.setRate(Number(value))}
      />
    </>
  );
}

export function TimeBar(): JSX.Element {
  const commands = useCommands();
  const times =
    useModel((model) => (model.chosen.value === null ? model.description.value?.times : undefined)) ?? NO_TIMES;
  const time = useModel((model) => model.scene.value?.time);
  if (times.length < 2) {
    // Reserves the space of the time bar. If the bar appeared later, the canvas would shrink, and the picture would be
    // drawn twice.
    return (
      <section class="time-bar hint" aria-label="Time">
        {times.length === 1 && "This dataset has one time step."}
      </section>
    );
  }
  const first = times[0] ?? 0;
  const last = times.at(-1) ?? 0;
  const step = nearestStep(times, time);
  const shown = formatNumber(times[step] ?? 0, last - first);
  return (
    <section class="time-bar" aria-label="Time">
      <Steps step={step} last={times.length - 1} />
      <Slider
        label="Time step"
        min={0}
        max={times.length - 1}
        step={1}
        value={step}
        text={`time ${shown}, step ${step + 1} of ${times.length}`}
        newGesture={() => commands.newGesture()}
        onChange={(value, gesture) => {
          commands.time.stop();
          commands.time.setStep(value, gesture);
        }}
      />
      <output class="time-readout">
        <span>t = {shown}</span>
        <small>
          {step + 1} / {times.length}
        </small>
      </output>
      <Pace />
    </section>
  );
}
