// Whether the two sides of welded seams still agree at another time.
#pragma once

#include "import/mesh/welds.hpp"

namespace ciel::importer {

// What the two sides of a seam differ in at this time: the name of a point field, or "position". Empty when they agree.
[[nodiscard]] std::string difference_across(const std::vector<Seam>& seams,
                                            const std::vector<JoinedMesh::Member>& parts);

} // namespace ciel::importer
