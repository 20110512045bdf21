// Counts the elements of a mesh, as `ciel info` reports them.
#pragma once

#include "ciel/topology.hpp"
#include "store/dataset.hpp"

namespace server::store {

// `counts`: of the mesh's topology. `bounds`: xmin xmax ymin ymax zmin zmax.
[[nodiscard]] MeshInfo count_mesh(const ciel::FaceMeshView& mesh, const ciel::TopologyCounts& counts,
                                  const std::array<double, 6>& bounds);
// `positions`: offsets from `origin`. bounds_of REQUIRES at least one vertex.
[[nodiscard]] std::array<double, 6> bounds_of(ciel::Vec3d origin, ciel::ValuesView positions);
void extend_bounds(std::array<double, 6>& bounds, ciel::Vec3d origin, ciel::ValuesView positions);
// Returns the total size of all records in bytes. Reads every record that the topology has not read yet.
[[nodiscard]] std::uint64_t record_bytes(const ciel::Topology& topology);

} // namespace server::store
