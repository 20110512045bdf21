// Counts the elements of a mesh, as `ciel info` reports them.
#pragma once

#include "ciel/topology.hpp"
#include "store/dataset.hpp"

namespace ciel::store {

// Returns the numbers of elements, the bounds and the cell types of a mesh. topology: the topology of the same mesh.
[[nodiscard]] MeshInfo count_mesh(const FaceMeshView& mesh, const Topology& topology);
// Extends `bounds` (xmin xmax ymin ymax zmin zmax) so that they also contain `positions`, which are offsets from
// `origin`.
void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, ValuesView positions);
// Returns the size of all records of the topology in bytes. Reads every record that the topology has not read yet.
[[nodiscard]] std::uint64_t record_bytes(const Topology& topology);

} // namespace ciel::store
