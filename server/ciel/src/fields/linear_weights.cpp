#include "ciel/linear_weights.hpp"

#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr double same_direction = 0.8;   // cosine of 37 degrees: normals at a smaller angle are merged
constexpr double least_of_another = 0.3; // sine of the smallest angle to the span of the earlier directions

// Solves m x = right for a symmetric matrix. `m`: its upper triangle, row by row. Returns how well-conditioned the
// matrix is, from 0 (singular; x is unchanged) to 1.
double solve(const std::array<double, 6>& m, Vec3d right, Vec3d& x) {
    const Vec3d a{m[0], m[1], m[2]};
    const Vec3d b{m[1], m[3], m[4]};
    const Vec3d c{m[2], m[4], m[5]};
    const double determinant = dot(a, cross(b, c));
    const double scale = m[0] + m[3] + m[5];
    const double relative = std::abs(determinant) / (scale * scale * scale);
    if (!(relative > 1e-9)) return 0;
    x = (1 / determinant) * Vec3d{dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))};
    return std::min(1e8 * (relative - 1e-9), 1.0);
}

void add_square(Vec3d d, double factor, std::array<double, 6>& moments) {
    moments[0] += factor * d[0] * d[0];
    moments[1] += factor * d[0] * d[1];
    moments[2] += factor * d[0] * d[2];
    moments[3] += factor * d[1] * d[1];
    moments[4] += factor * d[1] * d[2];
    moments[5] += factor * d[2] * d[2];
}

} // namespace

void LeftOutDirections::add(Vec3d normal) {
    const double size = length(normal);
    if (!(size > 0)) return;
    for (int i = 0; i < count_; ++i) {
        const double cosine = dot(normal, sums_[i]) / (size * length(sums_[i]));
        if (std::abs(cosine) < same_direction) continue;
        sums_[i] = sums_[i] + (cosine < 0 ? -1.0 : 1.0) * normal;
        return;
    }
    if (count_ < 3) sums_[count_++] = normal;
}

std::vector<Vec3d> LeftOutDirections::directions() const {
    std::vector<Vec3d> found;
    for (int i = 0; i < count_; ++i) {
        const Vec3d rest = without_parts_along(found, (1 / length(sums_[i])) * sums_[i]);
        if (length(rest) > least_of_another) found.push_back((1 / length(rest)) * rest);
    }
    return found;
}

Vec3d without_parts_along(std::span<const Vec3d> directions, Vec3d v) {
    for (const Vec3d& direction : directions) v = v - dot(v, direction) * direction;
    return v;
}

void linear_weights(std::span<Vec3d> displacements, std::span<const Vec3d> left_out, std::span<double> weights) {
    Vec3d sum{};
    std::array<double, 6> moments{};
    double total_by_distance = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        Vec3d& d = displacements[i];
        weights[i] = 1 / (length(d) + std::numeric_limits<float>::min());
        total_by_distance += weights[i];
        d = without_parts_along(left_out, d);
        sum = sum + d;
        add_square(d, 1, moments);
    }
    // The displacements have no components along `left_out`; without these moments, the system would be singular.
    const double scale = moments[0] + moments[3] + moments[5];
    for (const Vec3d& direction : left_out) add_square(direction, scale, moments);
    // The weights 1 + dot(lambda, d) give sum(weight * d) = 0. They are clipped so that none is negative.
    Vec3d lambda{};
    double trust = left_out.size() < 3 ? solve(moments, -1.0 * sum, lambda) : 0;
    const auto linear = [&lambda](Vec3d d) { return std::clamp(1 + dot(lambda, d), 0.0, 2.0); };
    double total = 0;
    for (const Vec3d& d : displacements) total += linear(d);
    // If all values lie on one side of the point, the sum of the clipped weights is mostly rounding noise.
    const auto count = static_cast<double>(weights.size());
    trust *= std::clamp((total / count - 0.05) / 0.2, 0.0, 1.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] *= (1 - trust) / total_by_distance;
        if (trust > 0) weights[i] += trust * linear(displacements[i]) / total;
    }
    if (std::ranges::all_of(weights, [](double weight) { return std::isfinite(weight); })) return;
    std::ranges::fill(weights, 1 / count); // some positions are not finite
}

} // namespace ciel
