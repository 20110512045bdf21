// The numbers that the solver gave to points and cells: GlobalIds, PedigreeIds, cellProcAddressing.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"

class vtkDataArray;
class vtkDataSet;

namespace ciel::importer {

// Returns the data set's ids of points or cells: VTK's global ids or GlobalNodeId/GlobalElementId, else the pedigree
// ids. Null if none of these holds integers.
[[nodiscard]] vtkDataArray* solver_id_array(vtkDataSet* data, FieldOf of);

// Returns the solver's id per running point or cell; -1 in blocks without ids. Empty if no block has ids.
[[nodiscard]] std::vector<std::int64_t> gather_solver_ids(const std::vector<JoinedMesh::Member>& parts, FieldOf of);

} // namespace ciel::importer
