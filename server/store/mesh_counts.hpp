// Counts the elements of a mesh, as `ciel info` reports them.
#pragma once

#include "ciel/topology.hpp"
#include "store/dataset.hpp"

namespace server::store {

[[nodiscard]] MeshInfo count_mesh(const ciel::FaceMeshView& mesh, const ciel::Topology& topology);
// `bounds`: xmin xmax ymin ymax zmin zmax. `positions`: offsets from `origin`.
void extend_bounds(std::array<double, 6>& bounds, ciel::Vec3d origin, ciel::ValuesView positions);
// Returns bytes. Reads every record that the topology has not read yet.
[[nodiscard]] std::uint64_t record_bytes(const ciel::Topology& topology);

} // namespace server::store
