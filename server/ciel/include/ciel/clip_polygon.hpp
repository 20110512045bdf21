// Clips a convex polygon by one plane (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ciel {

// Clips the convex polygon `corners`. Sets `kept` to the part where distance(position) >= 0, in the same winding.
// `kept` is empty if no part remains. `distance` must be linear in the position. `corners` may also be a line segment
// (two corners) or a single point.
template <class Distance>
void clip_polygon(std::span<const Vec3d> corners, const Distance& distance, std::vector<Vec3d>& kept) {
    kept.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double from = distance(a), to = distance(b);
        if (from >= 0) kept.push_back(a);
        if ((from >= 0) == (to >= 0)) continue;
        const double share = from / (from - to);
        kept.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])});
    }
}

} // namespace ciel
