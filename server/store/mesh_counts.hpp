// Counts of a mesh as `info` reports them.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

[[nodiscard]] MeshInfo count_mesh(const FaceMeshView& mesh);
// Grows [xmin xmax ymin ymax zmin zmax] to hold these positions too.
void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, std::span<const float> positions);

} // namespace ciel::store
