// What clip planes leave of a mesh's box.
#pragma once

#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// The corners of the convex body that is left, as offsets from the geometry's origin, some of them more than once; none
// where nothing is left. `cutting`: of any length.
[[nodiscard]] std::vector<Vec3d> corners_of_cut_box(const Geometry& geometry, const std::vector<HalfSpace>& cutting);

} // namespace ciel::geometry
