#include "geometry/mesh_side.hpp"

#include "ciel/threshold_surface.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::geometry {
namespace {

double rounding(std::array<float, 2> range) {
    return 1e-6 * (static_cast<double>(range[1]) - static_cast<double>(range[0]));
}

} // namespace

std::optional<double> side_at(double nu, std::array<float, 2> range) {
    const auto [low, high] = range;
    if (std::abs(nu - low) <= rounding(range)) return std::nextafter(low, high);
    if (std::abs(nu - high) <= rounding(range)) return high;
    return {};
}

Surface side_surface(const store::ScalarField& distances, double nu) {
    const FaceMeshView& mesh = distances.mesh;
    const auto values = distances.field->values();
    const double most = rounding(distances.field->range());
    std::vector<CellFace> faces;
    for (Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == none &&
            std::ranges::all_of(mesh.loop(face), [&](Index v) { return std::abs(values[v] - nu) <= most; }))
            faces.push_back({face, mesh.owner[face]});
    return face_surface(mesh, faces);
}

} // namespace ciel::geometry
