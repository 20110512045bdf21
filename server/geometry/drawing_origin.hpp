// The point to which the positions of pictures and polygon batches are relative. The positions are floats, which are
// imprecise far from their origin. For example, a boundary layer of thickness 2e-6 in a domain of size 100 needs an
// origin near the camera's target.
#pragma once

#include "annotations/camera.hpp"
#include "ciel/types.hpp"

namespace ciel::geometry {

// Returns `middle`, the middle of the mesh, if floats relative to it are precise to 1/30 of a pixel at the camera's
// target. Otherwise returns `last`, the result of the last call, if floats relative to `last` are as precise. Otherwise
// returns the camera's target.
[[nodiscard]] Vec3d drawing_origin(const Vec3d& middle, const Vec3d& last, const annotations::Camera& camera);

} // namespace ciel::geometry
