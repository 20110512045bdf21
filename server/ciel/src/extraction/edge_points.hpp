// Points at which nu cuts mesh edges, by linear interpolation (paper, section 2.2: "compute intersection").
#pragma once

#include "blocks/blocks.hpp"
#include "ciel/extract.hpp"

#include <algorithm>

namespace ciel::detail {

// Returns the position of nu between two values: 0 at `from`, 1 at `to`, clamped to [0, 1]. All points are made with
// this function, so that the point of an edge has the same bits wherever it is made. Returns 0 where the division gives
// NaN: if a record has changed, the ends of an edge may have any values.
[[nodiscard]] inline double share_at(double nu, double from, double to) {
    const double share = (nu - from) / (to - from);
    return share >= 0 ? std::min(share, 1.0) : 0.0;
}

// Returns the point at nu on an edge. `ends`: the two local vertices of the edge. `values`: by local vertex.
template <class Values>
[[nodiscard]] EdgePoint edge_point(const Block& block, const Values& values, const std::array<Index, 2>& ends,
                                   double nu) {
    return {block.vertex(ends[0]), block.vertex(ends[1]), share_at(nu, values[ends[0]], values[ends[1]])};
}

// Returns the position of `point`, plus `shift`. Rounds to float once, after the sum.
template <class Number>
[[nodiscard]] Vec3f position_of(const EdgePoint& point, std::span<const Number> positions, const Vec3d& shift) {
    const Number *a = &positions[3 * std::size_t{point.a}], *b = &positions[3 * std::size_t{point.b}];
    const auto along = [&](std::size_t axis) {
        return static_cast<float>(lerp(double{a[axis]}, double{b[axis]}, point.t) + shift[axis]);
    };
    return {along(0), along(1), along(2)};
}

} // namespace ciel::detail
