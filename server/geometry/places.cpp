#include "geometry/places.hpp"

#include "store/mesh_questions.hpp"

namespace server::geometry {

std::vector<ciel::Vec3d> places_of(const ciel::Surface& surface, const Geometry& geometry,
                                   const store::Dataset& dataset) {
    return store::positions_of(dataset, dataset.steps()[geometry.step], surface.points);
}

} // namespace server::geometry
