// A probe's result as text for a spreadsheet: one value per line, tab-separated columns, numbers with all digits.
import type { ProbeResult } from "../generated/protocol";

export interface ProbeContext {
  dataset: string;
  time: number;
  lengthUnits: string;
  unitsOf: (name: string) => string;
}

export function probeText(result: ProbeResult, context: ProbeContext): string {
  const { position, cell, vertex, patch, values, solver_cell, solver_vertex } = result;
  const rows: (string | number)[][] = [
    ["dataset", context.dataset],
    ["time", context.time],
    ...(["x", "y", "z"] as const).map((axis, i) => [axis, position?.[i] ?? "", context.lengthUnits]),
    ...(patch === null ? [] : [["patch", patch]]),
    ...(cell === null ? [] : [["cell", cell]]),
    ...(solver_cell === undefined ? [] : [["solver's cell", solver_cell]]),
    ...(vertex === null ? [] : [["nearest vertex", vertex]]),
    ...(solver_vertex === undefined ? [] : [["solver's nearest vertex", solver_vertex]]),
    ...Object.entries(values).map(([name, value]) => [name, value ?? "", context.unitsOf(name)]),
  ];
  return rows.map((row) => row.join("\t").trimEnd()).join("\n");
}
