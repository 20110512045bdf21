// Reports collapsed cells: cells with a face that names a point twice. They are kept, because files often store a wedge
// or pyramid as a collapsed hexahedron. Collapsed cells with fewer than four distinct corners have no volume.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace ciel::importer {

// Returns one sentence on collapsed cells and one on those without volume, if any: their count and first ten ids.
[[nodiscard]] std::vector<std::string> degenerate_cells(const JoinedMesh& joined);

} // namespace ciel::importer
