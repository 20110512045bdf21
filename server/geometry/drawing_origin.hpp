// The point to which the positions of pictures and polygon batches are relative. The positions are floats, which are
// coarse far from their origin: a boundary layer of 2e-6 in a far field of 100 needs an origin near the eye.
#pragma once

#include "annotations/camera.hpp"
#include "ciel/types.hpp"

namespace ciel::geometry {

// Returns `middle`, the middle of the mesh, if floats relative to it are finer than 1/30 of a pixel at the camera's
// target. Else returns `last`, the result of the last call, if floats relative to it are as fine, or else the target.
[[nodiscard]] Vec3d drawing_origin(const Vec3d& middle, const Vec3d& last, const annotations::Camera& camera);

} // namespace ciel::geometry
