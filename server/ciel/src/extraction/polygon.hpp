// Corners and area vectors of a surface's polygons (paper, algorithm 4). Any thread may call the functions.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/vectors.hpp"

namespace ciel::detail {

[[nodiscard]] inline std::span<const Index> polygon(const Surface& surface, std::size_t i) {
    const Index begin = surface.polygon_offset[i];
    return std::span(surface.polygon_vertex).subspan(begin, surface.polygon_offset[i + 1] - begin);
}

// Returns the normal of the polygon (right-hand rule), with twice the area as its length. Uses offsets from the first
// corner, to stay precise far from the origin. REQUIRES: `loop` has at least two corners.
[[nodiscard]] inline Vec3d area_vector(std::span<const Vec3f> positions, std::span<const Index> loop) {
    Vec3d sum{};
    Vec3d a = arm(positions[loop[0]], positions[loop[1]]);
    for (std::size_t i = 2; i < loop.size(); ++i) {
        const Vec3d b = arm(positions[loop[0]], positions[loop[i]]);
        const Vec3d part = cross(a, b);
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
        a = b;
    }
    return sum;
}

} // namespace ciel::detail
