// Lists the sides of a surface's polygons, grouped by the lower point, without a hash table. Not in the paper.
#pragma once

#include "ciel/extract.hpp"
#include "extraction/polygon.hpp"

#include <algorithm>

namespace ciel::detail {

template <class Side>
struct PolygonSides {
    std::vector<Index> begin; // by lower point: its first index in `side`; the last item is the size of `side`
    std::vector<Side> side;

    [[nodiscard]] std::span<Side> of(Index lower) {
        return std::span(side).subspan(begin[lower], begin[lower + 1] - begin[lower]);
    }
};

// Calls f(lower point, upper point, polygon). A side of two polygons is visited twice. Skips sides of no length.
template <class F>
void for_sides(const Surface& surface, F&& f) {
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        Index before = loop.back();
        for (const Index point : loop) {
            if (point != before) f(std::min(point, before), std::max(point, before), static_cast<Index>(i));
            before = point;
        }
    }
}

// Returns make(upper point, polygon) for each side, grouped by lower point. Each group is sorted.
template <class Make>
[[nodiscard]] auto polygon_sides(const Surface& surface, Make make) {
    PolygonSides<std::decay_t<decltype(make(Index{}, Index{}))>> out;
    out.begin.resize(surface.positions.size() + 2);
    for_sides(surface, [&](Index lower, Index, Index) { ++out.begin[lower + 2]; });
    for (std::size_t i = 2; i < out.begin.size(); ++i) out.begin[i] += out.begin[i - 1];
    out.side.resize(out.begin.back());
    for_sides(surface, [&](Index lower, Index upper, Index polygon) {
        out.side[out.begin[lower + 1]++] = make(upper, polygon);
    });
    out.begin.pop_back();
    for (Index lower = 0; lower < surface.positions.size(); ++lower) {
        const auto bucket = out.of(lower);
        std::sort(bucket.begin(), bucket.end());
    }
    return out;
}

} // namespace ciel::detail
