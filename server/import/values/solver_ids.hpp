// The ids that the solver gave to points and cells: GlobalIds, PedigreeIds, cellProcAddressing.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"

class vtkDataArray;
class vtkDataSet;

namespace server::importer {

// Returns the first of these arrays that holds integers: VTK's global ids, the array GlobalNodeId or GlobalElementId,
// VTK's pedigree ids, the array PedigreeNodeId or PedigreeElementId. Returns null if none of them holds integers.
[[nodiscard]] vtkDataArray* solver_id_array(vtkDataSet* data, FieldOf of);

// Returns one id per running point or cell. Points and cells of members without ids get -1. Returns an empty list if no
// member has ids.
[[nodiscard]] std::vector<std::int64_t> gather_solver_ids(const std::vector<JoinedMesh::Member>& members, FieldOf of);

} // namespace server::importer
