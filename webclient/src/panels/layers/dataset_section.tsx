// Description of the dataset: a summary, and all details when unfolded.
import type { JSX } from "preact";
import type { DatasetDescription } from "../../generated/protocol";
import { arrayFacts } from "../../model/array_facts";
import { extremesText } from "../../model/cell_extremes";
import { datasetFacts } from "../../model/dataset_facts";
import { prettyUnits } from "../../model/layout";
import { formatCount, formatNumber } from "../../model/numbers";
import { Section } from "../controls/controls";
import { useModel } from "../context";

function Row({ name, value }: { name: string; value: string }): JSX.Element {
  return (
    <>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </>
  );
}

function Summary({ description }: { description: DatasetDescription }): JSX.Element {
  return (
    <div class="dataset-summary">
      <strong>{description.name}</strong>
      <p>{datasetFacts(description).join(" \u00b7 ")}</p>
      {description.source !== "" && <p class="hint">{`from ${description.source}`}</p>}
    </div>
  );
}

function Arrays({ description: { arrays, times } }: { description: DatasetDescription }): JSX.Element {
  return (
    <table class="arrays">
      <thead>
        <tr>
          <th scope="col">Array</th>
          <th scope="col">Range</th>
          <th scope="col">Units</th>
        </tr>
      </thead>
      <tbody>
        {arrays.map((array) => (
          <tr key={`${array.association} ${array.name}`} title={array.description}>
            <th scope="row">
              {array.name}
              {array.components > 1 && <small> {array.components} components</small>}
              <small class="array-facts">{arrayFacts(array, times.length).join(" \u00b7 ")}</small>
              {array.association === "cell" && array.extremes !== undefined && (
                <small class="array-facts">{extremesText(array.extremes)}</small>
              )}
            </th>
            <td>
              {array.range === null
                ? ""
                : array.range
                    .map((v) => formatNumber(v, (array.range?.[1] ?? 0) - (array.range?.[0] ?? 0)))
                    .join(" to ")}
            </td>
            <td>{prettyUnits(array.units)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

export function DatasetSection(): JSX.Element | null {
  const description = useModel((model) => model.description.value);
  const server = useModel((model) => model.server.value);
  if (description === null) return null;
  const { mesh, bounds, times, length_units: units } = description;
  const extent = (axis: number): string => {
    const low = bounds[2 * axis] ?? 0;
    const high = bounds[2 * axis + 1] ?? 0;
    return `${formatNumber(low, high - low)} to ${formatNumber(high, high - low)} ${units}`.trim();
  };
  const cells = Object.entries(mesh.cells).sort(([, a], [, b]) => b - a);
  const span = (times.at(-1) ?? 0) - (times[0] ?? 0);
  return (
    <Section title="Dataset" open={false} summary={<Summary description={description} />}>
      <dl class="facts">
        {cells.map(([type, count]) => (
          <Row key={type} name={type} value={formatCount(count)} />
        ))}
        <Row name="Vertices" value={formatCount(mesh.vertices)} />
        <Row name="Edges" value={formatCount(mesh.edges)} />
        <Row name="Faces" value={formatCount(mesh.faces)} />
        <Row name="Boundary faces" value={formatCount(mesh.boundary_faces)} />
        <Row name="Components" value={formatCount(mesh.components)} />
        {(["x", "y", "z"] as const).map((axis, index) => (
          <Row key={axis} name={axis} value={extent(index)} />
        ))}
        <Row
          name="Time steps"
          value={
            times.length > 1
              ? `${times.length}, ${formatNumber(times[0] ?? 0, span)} to ${formatNumber(times.at(-1) ?? 0, span)}`
              : String(times.length)
          }
        />
        {server !== null && <Row name="Server" value={`CIEL ${server.version}, ${server.gl_renderer}`} />}
      </dl>
      <Arrays description={description} />
      {description.notes.length > 0 && (
        <ul class="notes">
          {description.notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
    </Section>
  );
}
