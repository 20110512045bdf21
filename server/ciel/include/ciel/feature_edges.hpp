// Finds the feature edges of a surface: edges at a crease, on the border, and edges of more than two polygons. Not in
// the paper, whose "mesh" of a surface is all polygon edges (polygon_edges.hpp).
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns two vertex indices for each edge, the lower index first, in ascending order. An edge is included if it does
// not belong to exactly two polygons, or if the normals of its two polygons differ by more than `degrees`. A polygon
// without area has no normal, so angles at its edges are not tested.
[[nodiscard]] std::vector<Index> feature_edges(const Surface& surface, double degrees);

} // namespace ciel
