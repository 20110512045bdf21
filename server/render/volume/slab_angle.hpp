// Computes the largest angle between the rays of a picture and the normal of its slabs.
#pragma once

#include "render/volume/volume_rays.hpp"

namespace server::render {

// Returns the tangent of the largest angle between a ray of the picture and `normal`, or an upper bound. Returns
// infinity if a ray may run parallel to the slabs.
[[nodiscard]] double slab_angle(const VolumeView& view, const ciel::Vec3d& normal);

} // namespace server::render
