// Lists the edges of a surface's polygons, each once: the paper's "mesh" of a surface (section 2.1).
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns two indices into the points of the surface per edge, the lower first, in ascending order. The result does not
// depend on the order of the polygons. Only polygon sides are included, no triangulation edges. An edge from a point to
// itself (collapsed cells) is left out.
[[nodiscard]] std::vector<Index> polygon_edges(const Surface& surface);

} // namespace ciel
