// The positions of a surface's vertices in the dataset's coordinates, as doubles that are as precise as the positions
// of the mesh. Files get these doubles; pictures need only floats.
#pragma once

#include "geometry/geometry.hpp"

namespace server::geometry {

// Returns one position per vertex of a surface of `geometry`. `dataset`: the dataset that `geometry` shows.
[[nodiscard]] std::vector<ciel::Vec3d> places_of(const ciel::Surface& surface, const Geometry& geometry,
                                                 const store::Dataset& dataset);

} // namespace server::geometry
