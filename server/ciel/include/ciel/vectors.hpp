// Arithmetic on three-vectors in double precision, because a product of two floats may need more bits than a float has.
// Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cmath>

namespace ciel {

[[nodiscard]] inline Vec3d arm(const Vec3f& from, const Vec3f& to) {
    return {static_cast<double>(to[0]) - from[0], static_cast<double>(to[1]) - from[1],
            static_cast<double>(to[2]) - from[2]};
}

template <class A, class B>
[[nodiscard]] inline double dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
    return static_cast<double>(a[0]) * b[0] + static_cast<double>(a[1]) * b[1] + static_cast<double>(a[2]) * b[2];
}

[[nodiscard]] inline Vec3d cross(const Vec3d& a, const Vec3d& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Returns `v` scaled to length 1. Returns zero if the length of `v` is zero or not finite.
[[nodiscard]] inline Vec3f unit(const Vec3d& v) {
    const double length = std::sqrt(dot(v, v));
    if (!(length > 0) || !std::isfinite(length)) return {};
    const double scale = 1 / length;
    return {static_cast<float>(v[0] * scale), static_cast<float>(v[1] * scale), static_cast<float>(v[2] * scale)};
}

} // namespace ciel
