// Edges at which a surface bends, ends or branches. Not in the paper: its "mesh" of a surface has all edges
// (polygon_edges.hpp), too many to show the shape.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns two indices per edge, in the form of polygon_edges. An edge is included if the normals of its two polygons
// differ by more than `degrees`, or if it does not belong to exactly two polygons. A polygon without area does not
// bend.
[[nodiscard]] std::vector<Index> feature_edges(const Surface& surface, double degrees);

} // namespace ciel
