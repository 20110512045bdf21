#include "ciel/polygon_edges.hpp"

#include "ciel/polygon.hpp"

#include <algorithm>

namespace ciel {

namespace {

// Calls f(lower, upper) for each side of each polygon; an edge of two polygons comes twice.
template <class F>
void for_sides(const Surface& surface, F&& f) {
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        Index before = loop.back();
        for (const Index point : loop) {
            if (point != before) f(std::min(point, before), std::max(point, before));
            before = point;
        }
    }
}

} // namespace

// Sides are put into a bucket per lower point, where the few upper ones are sorted: no hash, no sort of everything.
std::vector<Index> polygon_edges(const Surface& surface) {
    std::vector<Index> begin(surface.positions.size() + 2);
    for_sides(surface, [&](Index lower, Index) { ++begin[lower + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Index> upper(begin.back());
    for_sides(surface, [&](Index lower, Index to) { upper[begin[lower + 1]++] = to; });

    std::vector<Index> edges;
    edges.reserve(upper.size() + upper.size() / 8); // most have two sides, so half as many edges of two ends each
    for (Index lower = 0; lower < surface.positions.size(); ++lower) {
        const auto first = upper.begin() + begin[lower], last = upper.begin() + begin[lower + 1];
        std::sort(first, last);
        const auto end = std::unique(first, last);
        for (auto at = first; at != end; ++at) edges.insert(edges.end(), {lower, *at});
    }
    return edges;
}

} // namespace ciel
