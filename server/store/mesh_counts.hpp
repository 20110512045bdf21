// Counts the elements of a mesh, as `ciel info` reports them.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

[[nodiscard]] MeshInfo count_mesh(const FaceMeshView& mesh);
// Extends bounds [xmin xmax ymin ymax zmin zmax] to contain these positions too, which are offsets from `origin`.
void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, std::span<const float> positions);

} // namespace ciel::store
