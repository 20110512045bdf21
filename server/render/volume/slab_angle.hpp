// How slanted the rays of a picture are to a volume's slabs.
#pragma once

#include "render/volume/volume_rays.hpp"

namespace ciel::render {

// The tangent of the widest angle between the volumes' normal and a ray of the picture that meets their box;
// infinite where one may run along the slabs.
[[nodiscard]] double slab_angle(const VolumeView& view, const Vec3d& normal);

} // namespace ciel::render
