// Cells with corners that are the same point in the file. They are kept: a collapsed hexahedron is a common way to
// write a wedge or a pyramid. One of fewer than four different corners has no volume.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace ciel::importer {

// Sentences with how many there are of each, and the first of them.
[[nodiscard]] std::vector<std::string> degenerate_cells(const JoinedMesh& joined);

} // namespace ciel::importer
