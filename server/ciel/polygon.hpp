// Polygons of a surface: their corners, directions and area.
#pragma once

#include "ciel/extract.hpp"

#include <cmath>

namespace ciel {

[[nodiscard]] inline std::span<const Index> polygon(const Surface& surface, std::size_t i) {
    const Index begin = surface.polygon_offset[i];
    return std::span(surface.polygon_vertex).subspan(begin, surface.polygon_offset[i + 1] - begin);
}

[[nodiscard]] inline Vec3d arm(const Vec3f& from, const Vec3f& to) {
    return {static_cast<double>(to[0]) - from[0], static_cast<double>(to[1]) - from[1],
            static_cast<double>(to[2]) - from[2]};
}

[[nodiscard]] inline Vec3d cross(const Vec3d& a, const Vec3d& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Zero stays zero. In double: the squares of small vectors vanish in float.
[[nodiscard]] inline Vec3f unit(const Vec3d& v) {
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0) || !std::isfinite(length)) return {};
    const double scale = 1 / length;
    return {static_cast<float>(v[0] * scale), static_cast<float>(v[1] * scale), static_cast<float>(v[2] * scale)};
}

// Twice the area, along the right-hand normal; taken about the first corner, so it does not suffer far from the origin.
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

} // namespace ciel
