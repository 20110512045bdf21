// Lists each edge of a surface's polygons once: the paper's "mesh" of a surface (section 2.1).
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Returns two vertex indices for each edge, the lower index first, in ascending order. The result does not depend on
// the order of the polygons. Only sides of polygons are listed, not edges of a triangulation. A side from a vertex to
// itself (in collapsed cells) is left out.
[[nodiscard]] std::vector<Index> polygon_edges(const Surface& surface);

} // namespace ciel
