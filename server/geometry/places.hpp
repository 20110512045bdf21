// The vertices of a surface in the dataset's coordinates, as precise as its mesh. Pictures need floats only; files get
// these.
#pragma once

#include "geometry/geometry.hpp"

namespace ciel::geometry {

// Returns one place per vertex of a surface of `geometry`. `dataset`: that of the geometry.
[[nodiscard]] std::vector<Vec3d> places_of(const Surface& surface, const Geometry& geometry,
                                           const store::Dataset& dataset);

} // namespace ciel::geometry
