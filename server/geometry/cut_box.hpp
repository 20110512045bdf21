// The part of a mesh's bounding box that the clip planes keep.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Offsets from the geometry's origin, possibly with duplicates. `cutting`: clip planes, with normals of any length.
[[nodiscard]] std::vector<Vec3d> corners_of_cut_box(const Geometry& geometry, const std::vector<HalfSpace>& cutting);

} // namespace ciel::geometry
