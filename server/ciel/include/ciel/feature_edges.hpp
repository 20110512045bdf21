// Finds the feature edges of a surface: those where it bends, ends or branches. Not in the paper, whose "mesh" of a
// surface has all polygon edges (polygon_edges.hpp).
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns two vertex indices per edge, the lower first, in ascending order. An edge is included if the normals of its
// two polygons differ by more than `degrees`, or if it does not belong to exactly two polygons. A polygon without area
// has no normal, so the first rule does not apply to its edges.
[[nodiscard]] std::vector<Index> feature_edges(const Surface& surface, double degrees);

} // namespace ciel
