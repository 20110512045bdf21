// The edges at which a surface bends, ends or branches. Not in the paper: its "mesh" of a surface shows all edges
// (polygon_edges.hpp), which are too many to see a shape by.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Two indices per edge, as polygon_edges has them: those between polygons whose normals differ by more than `degrees`,
// and those that do not belong to exactly two polygons. A polygon without area bends nowhere.
[[nodiscard]] std::vector<Index> feature_edges(const Surface& surface, double degrees);

} // namespace ciel
