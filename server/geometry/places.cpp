#include "geometry/places.hpp"

#include "store/mesh_questions.hpp"

namespace ciel::geometry {

std::vector<Vec3d> places_of(const Surface& surface, const Geometry& geometry, const store::Dataset& dataset) {
    return store::positions_of(dataset, dataset.steps()[geometry.step], surface.points);
}

} // namespace ciel::geometry
