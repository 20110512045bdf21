#include "geometry/mesh_side.hpp"

#include "ciel/vector_operators.hpp"
#include "geometry/cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace server::geometry {
namespace {

// The error of doubles comes from the coordinates from which the distances were computed.
double rounding(const store::ScalarField& distances) {
    const auto [low, high] = distances.field->range();
    if (!distances.has_double_positions()) return 1e-6 * (high - low);
    const double coordinate = ciel::length(distances.surface_origin()) + std::max(std::abs(low), std::abs(high));
    return 16 * std::numeric_limits<double>::epsilon() * coordinate;
}

} // namespace

std::optional<double> side_at(double nu, const store::ScalarField& distances) {
    const auto [low, high] = distances.field->range();
    const double most = rounding(distances);
    if (std::abs(nu - low) <= most)
        return distances.has_double_positions()
                   ? std::nextafter(low, high)
                   : double{std::nextafter(static_cast<float>(low), static_cast<float>(high))};
    if (std::abs(nu - high) <= most) return high;
    return {};
}

ciel::Surface side_surface(const store::ScalarField& distances, double nu) {
    return distances.boundary_at(nu, rounding(distances));
}

} // namespace server::geometry
