// Points at which nu cuts edges, by linear interpolation between the ends (paper, section 2.2: "compute intersection").
#pragma once

#include "blocks/blocks.hpp"
#include "ciel/extract.hpp"

#include <algorithm>

namespace ciel {

// Returns the position of nu between two values, clamped to [0, 1]: 0 at `from`, 1 at `to`. All points are made with
// this function, so the point of an edge has the same bits wherever it is made. Returns 0 where the division gives NaN,
// because the ends of an edge in a changed record may have any values.
[[nodiscard]] inline double share_at(double nu, double from, double to) {
    const double share = (nu - from) / (to - from);
    return share >= 0 ? std::min(share, 1.0) : 0.0;
}

// Returns the point at nu on an edge. `ends`: local vertices of the block. `values`: by local vertex.
template <class Values>
[[nodiscard]] EdgePoint edge_point(const Block& block, const Values& values, const std::array<Index, 2>& ends,
                                   double nu) {
    return {block.vertex(ends[0]), block.vertex(ends[1]), share_at(nu, values[ends[0]], values[ends[1]])};
}

// Returns the position of the point plus `shift`. Rounds once, after the sum.
template <class Number>
[[nodiscard]] Vec3f position_of(const EdgePoint& point, std::span<const Number> positions, const Vec3d& shift) {
    const Number *a = &positions[3 * std::size_t{point.a}], *b = &positions[3 * std::size_t{point.b}];
    const auto along = [&](std::size_t axis) {
        return static_cast<float>(lerp(double{a[axis]}, double{b[axis]}, point.t) + shift[axis]);
    };
    return {along(0), along(1), along(2)};
}

} // namespace ciel
