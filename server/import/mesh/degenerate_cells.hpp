// Reports collapsed cells: cells with a face that uses a point more than once. The import keeps these cells, because
// files often store a wedge or pyramid as a collapsed hexahedron.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace server::importer {

// Returns at most two sentences: one about collapsed cells with volume, and one about those without volume. Each
// sentence lists the first ten ids.
[[nodiscard]] std::vector<std::string> degenerate_cells(const JoinedMesh& joined);

} // namespace server::importer
