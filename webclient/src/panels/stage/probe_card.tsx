// Card with the values at the clicked point, and a mark at that point.
import type { JSX } from "preact";
import type { Vec3 } from "../../generated/protocol";
import { project } from "../../model/camera";
import { extremesText } from "../../model/cell_extremes";
import { formatNumber } from "../../model/numbers";
import { measured } from "../../model/scalars";
import { IconButton } from "../controls/controls";
import { useCommands, useModel, useCamera } from "../context";

function PatchRow({ layer, patch }: { layer: string; patch: string }): JSX.Element {
  const commands = useCommands();
  return (
    <div class="probe-patch">
      <span>
        Patch <strong>{patch}</strong>
      </span>
      <div class="row">
        <button type="button" class="button small" onClick={() => commands.layers.hidePatch(layer, patch)}>
          Hide
        </button>
        <button type="button" class="button small" onClick={() => commands.layers.onlyPatch(layer, patch)}>
          Only this
        </button>
      </div>
    </div>
  );
}

/** A separate component, because it is rendered again at each move of the camera. */
function ProbeMark({ position }: { position: Vec3 }): JSX.Element | null {
  const size = useModel((model) => model.canvasSize.value);
  const camera = useCamera();
  const mark = camera === null ? null : project(camera, position, size);
  if (mark === null) return null;
  return <div class="probe-mark" style={{ left: `${mark.x}px`, top: `${mark.y}px` }} aria-hidden="true" />;
}

const solverId = (id: number | undefined): string => (id === undefined ? "" : ` (${id} to the solver)`);

export function ProbeCard(): JSX.Element | null {
  const commands = useCommands();
  const probe = useModel((model) => model.probe.value);
  const description = useModel((model) => model.description.value);
  const shownTime = useModel((model) => model.readout.value.time);
  const position = probe?.result.position;
  if (probe === null || !position) return null;
  const { result } = probe;
  const units = description?.length_units ?? "";
  return (
    <>
      <ProbeMark position={position} />
      <aside class="probe" aria-label="Values at the clicked point" aria-live="polite">
        <header>
          <strong>{`(${position.map((v) => formatNumber(v)).join(", ")}) ${units}`.trim()}</strong>
          <IconButton icon="copy" label="Copy the values" onClick={() => void commands.probe.copy()} />
          <IconButton icon="close" label="Close the values" onClick={() => commands.probe.close()} />
        </header>
        {result.layer !== null && result.patch !== null && <PatchRow layer={result.layer} patch={result.patch} />}
        <dl class="facts">
          {Object.entries(result.values).map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value === null ? "no value here" : measured(description, name, value)}</dd>
            </div>
          ))}
        </dl>
        <p class="hint">
          {[
            result.cell === null ? "" : `cell ${result.cell}${solverId(result.solver_cell)}`,
            result.vertex === null ? "" : `nearest vertex ${result.vertex}${solverId(result.solver_vertex)}`,
            probe.time === shownTime ? "" : `at t = ${formatNumber(probe.time)}`,
          ]
            .filter((part) => part !== "")
            .join(", ")}
        </p>
        {Object.entries(result.extremes ?? {}).map(([name, extremes]) => (
          <p key={name} class="hint">{`${name}: ${extremesText(extremes)}`}</p>
        ))}
      </aside>
    </>
  );
}
