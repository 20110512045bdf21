// Sums, multiples and lengths of three-vectors of doubles. Not in the paper.
#pragma once

#include "ciel/vectors.hpp"

#include <cmath>

namespace ciel {

[[nodiscard]] inline Vec3d operator+(Vec3d a, Vec3d b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
[[nodiscard]] inline Vec3d operator-(Vec3d a, Vec3d b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
[[nodiscard]] inline Vec3d operator*(double s, Vec3d a) { return {s * a[0], s * a[1], s * a[2]}; }
[[nodiscard]] inline double length(const Vec3d& a) { return std::sqrt(dot(a, a)); }

} // namespace ciel
