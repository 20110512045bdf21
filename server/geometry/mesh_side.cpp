#include "geometry/mesh_side.hpp"

#include "ciel/mesh_faces.hpp"

#include <cmath>

namespace ciel::geometry {
namespace {

double rounding(std::array<double, 2> range) { return 1e-6 * (range[1] - range[0]); }

} // namespace

std::optional<double> side_at(double nu, std::array<double, 2> range) {
    const auto [low, high] = range;
    if (std::abs(nu - low) <= rounding(range)) return std::nextafter(static_cast<float>(low), static_cast<float>(high));
    if (std::abs(nu - high) <= rounding(range)) return high;
    return {};
}

Surface side_surface(const store::ScalarField& distances, double nu) {
    const auto mesh = distances.mesh();
    const double most = rounding(distances.field->range());
    return face_surface(mesh, boundary_faces_at(mesh, *distances.field, nu, most));
}

} // namespace ciel::geometry
