// One plane's cut through a convex polygon (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). Not in the
// paper.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ciel {

// kept: replaced by the corners of what lies where distance(corner) >= 0, in order; empty where nothing does. A line of
// two corners and a single corner are clipped too.
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
