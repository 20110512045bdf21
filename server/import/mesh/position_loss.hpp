// Counts cells that change because a dataset stores positions as 32-bit floats. A picture does not show this loss.
#pragma once

#include "import/mesh/joined_mesh.hpp"

#include <string>
#include <vector>

namespace ciel::importer {

// Returns sentences with the number of cells whose corners differ in the input but not as floats, and of cells whose
// volume changes by more than 1 %. `mesh`: before welding.
[[nodiscard]] std::vector<std::string> position_loss(const JoinedMesh& mesh);

} // namespace ciel::importer
