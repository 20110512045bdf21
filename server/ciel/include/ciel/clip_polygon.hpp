// Clips a polygon by one plane (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace ciel {

// Walks around the polygon `corners`, in the same winding. Calls keep(a) for each corner a for which keeps(a) is true,
// and cross(a, b) for each side from a to b of which only one end is kept. `corners` may also be a line segment (two
// corners) or a single point.
template <class Corner, class Keeps, class Keep, class Cross>
void walk_kept_part(std::span<const Corner> corners, const Keeps& keeps, const Keep& keep, const Cross& cross) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const bool from = keeps(a), to = keeps(b);
        if (from) keep(a);
        if (from != to) cross(a, b);
    }
}

// Clips the convex polygon `corners`. Sets `kept` to the part where distance(position) >= 0, in the same winding.
// `kept` is empty if no part remains. `distance` must be linear in the position.
template <class Distance>
void clip_polygon(std::span<const Vec3d> corners, const Distance& distance, std::vector<Vec3d>& kept) {
    kept.clear();
    walk_kept_part(
        corners, [&](const Vec3d& corner) { return distance(corner) >= 0; },
        [&](const Vec3d& corner) { kept.push_back(corner); },
        [&](const Vec3d& a, const Vec3d& b) {
            const double from = distance(a), share = from / (from - distance(b));
            kept.push_back({a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])});
        });
}

} // namespace ciel
