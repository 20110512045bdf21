// Counts the elements of a mesh, as `ciel info` reports them.
#pragma once

#include "ciel/topology.hpp"
#include "store/dataset.hpp"

namespace ciel::store {

[[nodiscard]] MeshInfo count_mesh(const FaceMeshView& mesh, const Topology& topology);
// `bounds`: xmin xmax ymin ymax zmin zmax. `positions`: offsets from `origin`.
void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, ValuesView positions);
// Returns bytes. Reads every record that the topology has not read yet.
[[nodiscard]] std::uint64_t record_bytes(const Topology& topology);

} // namespace ciel::store
