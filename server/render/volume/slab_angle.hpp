// The widest angle between the rays of a picture and a volume's normal.
#pragma once

#include "render/volume/volume_rays.hpp"

namespace ciel::render {

// Returns the tangent of the widest angle between the volumes' normal and a ray of the picture that meets their box.
// Infinite where a ray may run along the slabs.
[[nodiscard]] double slab_angle(const VolumeView& view, const Vec3d& normal);

} // namespace ciel::render
