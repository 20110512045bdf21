// Computes the positions of single cells of a mesh.
#pragma once

#include "ciel/topology.hpp"

#include <map>

namespace ciel::store {

// Returns for each of `cells` the mean of its corners, in the dataset's coordinates. points: positions of the
// topology's vertices. Reads the blocks of the cells. Throws Error when the mesh has no such cell or a record is
// damaged.
[[nodiscard]] std::map<Index, Vec3d> cell_places(const Topology& topology, const FaceMeshView& points,
                                                 const std::vector<Index>& cells);

} // namespace ciel::store
