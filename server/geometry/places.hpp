// The vertices of a surface in the dataset's coordinates, as precise as those of the mesh. Files get these doubles;
// pictures need only floats.
#pragma once

#include "geometry/geometry.hpp"

namespace ciel::geometry {

// Returns one place per vertex of a surface of `geometry`. `dataset`: the one that `geometry` shows.
[[nodiscard]] std::vector<Vec3d> places_of(const Surface& surface, const Geometry& geometry,
                                           const store::Dataset& dataset);

} // namespace ciel::geometry
