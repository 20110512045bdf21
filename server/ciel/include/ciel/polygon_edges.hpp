// The edges of a surface's polygons, each once: the paper's "mesh" of a surface (section 2.1), as index pairs into the
// surface's own points.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

// Two indices per edge, the lower first, ascending: the same bits whatever the order of the polygons. They are those of
// the polygons as cells have them, so nothing of a triangulation is among them. An edge from a point to itself
// (collapsed cells) is none.
[[nodiscard]] std::vector<Index> polygon_edges(const Surface& surface);

} // namespace ciel
