// The point to which the positions of pictures and polygon batches are relative. The positions are floats, which are
// imprecise far from their origin.
#pragma once

#include "annotations/camera.hpp"
#include "ciel/types.hpp"

namespace server::geometry {

// Returns `middle`, the middle of the mesh, if floats relative to `middle` are precise to 1/30 of a pixel at the
// camera's target. Otherwise returns `last`, the result of the last call, if `last` is as precise. Otherwise returns
// the camera's target.
[[nodiscard]] ciel::Vec3d drawing_origin(const ciel::Vec3d& middle, const ciel::Vec3d& last,
                                         const annotations::ViewCamera& camera);

} // namespace server::geometry
