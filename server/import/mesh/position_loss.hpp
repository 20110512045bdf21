// What a mesh loses because a dataset holds 32-bit positions. It is counted and said: nobody can see it in a picture.
#pragma once

#include "import/mesh/joined_mesh.hpp"

#include <string>
#include <vector>

namespace ciel::importer {

// Sentences. Of the joined mesh before welding: cells with corners that are apart in the input and one here, and cells
// whose volume changes by 1 %.
[[nodiscard]] std::vector<std::string> position_loss(const JoinedMesh& mesh);

} // namespace ciel::importer
