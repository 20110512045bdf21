// The part of a mesh's bounding box that the clip planes keep.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace server::geometry {

// Returns the corners of this part as offsets from the geometry's origin, possibly with duplicates. `cutting`: clip
// planes, with normals of any length.
[[nodiscard]] std::vector<ciel::Vec3d> corners_of_cut_box(const Geometry& geometry,
                                                          const std::vector<ciel::HalfSpace>& cutting);

} // namespace server::geometry
