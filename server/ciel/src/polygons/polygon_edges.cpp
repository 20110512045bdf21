#include "ciel/polygon_edges.hpp"

#include "polygons/polygon_sides.hpp"

namespace ciel {

using detail::polygon_sides;

std::vector<Index> polygon_edges(const Surface& surface) {
    auto sides = polygon_sides(surface, [](Index upper, Index) { return upper; });
    std::vector<Index> edges;
    // Estimate of the result's size: most edges are a side of two polygons, and each edge appends two indices.
    edges.reserve(sides.side.size() + sides.side.size() / 8);
    for (Index lower = 0; lower < surface.positions.size(); ++lower) {
        const std::span<Index> upper = sides.of(lower);
        const auto end = std::unique(upper.begin(), upper.end());
        for (auto at = upper.begin(); at != end; ++at) edges.insert(edges.end(), {lower, *at});
    }
    return edges;
}

} // namespace ciel
