// Compares the two sides of seams, before welding and again at each step.
#pragma once

#include "import/mesh/welds.hpp"

namespace server::importer {

// Returns "position" or the name of a point field that differs; empty if the sides of all seams agree.
[[nodiscard]] std::string difference_across(const std::vector<Seam>& seams,
                                            const std::vector<JoinedMesh::Member>& members);

} // namespace server::importer
