// Reports collapsed cells: cells with a face that uses a point more than once. The import keeps these cells, because
// files often store a wedge or pyramid as a collapsed hexahedron. A collapsed cell with fewer than four distinct
// corners has no volume.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace ciel::importer {

// Returns at most two sentences: one on collapsed cells with volume, and one on collapsed cells without volume. Each
// sentence gives the number of cells and the first ten ids.
[[nodiscard]] std::vector<std::string> degenerate_cells(const JoinedMesh& joined);

} // namespace ciel::importer
