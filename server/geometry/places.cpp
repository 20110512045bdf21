#include "geometry/places.hpp"

#include "ciel/vector_operators.hpp"

namespace ciel::geometry {

std::vector<Vec3d> places_of(const Surface& surface, const Geometry& geometry, const store::Dataset& dataset) {
    const store::Step& step = dataset.steps()[geometry.step];
    const auto mesh = dataset.points_to_load(step.mesh, step.coordinates);
    std::vector<Vec3d> places(surface.points.size());
    mesh.positions.with([&](const auto& all) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto& [a, b, t] = surface.points[i];
            for (const Index vertex : {a, b})
                if (mesh.loader != nullptr) mesh.loader->load(vertex, vertex + 1);
            for (std::size_t axis = 0; axis < 3; ++axis)
                places[i][axis] = mesh.origin[axis] + lerp(double{all[3 * std::size_t{a} + axis]},
                                                           double{all[3 * std::size_t{b} + axis]}, t);
        }
    });
    return places;
}

} // namespace ciel::geometry
