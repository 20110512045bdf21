// The numbers that the solver gave to points and cells: GlobalIds, PedigreeIds, cellProcAddressing.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"

namespace ciel::importer {

// The array of numbers that a data set has for its points or cells: the one that VTK marks as global ids, or of that
// name, else the pedigree ids. Null where there is none of whole numbers.
[[nodiscard]] vtkDataArray* solver_id_array(vtkDataSet* data, FieldOf of);

// By running id; -1 where a block has none. Empty where no block has any.
[[nodiscard]] std::vector<std::int64_t> gather_solver_ids(const std::vector<JoinedMesh::Member>& parts, FieldOf of);

} // namespace ciel::importer
