// Computes the center positions of selected cells of a mesh.
#pragma once

#include "ciel/topology.hpp"

#include <map>

namespace ciel::store {

// Returns for each cell of `cells` the mean position of its corners, in dataset coordinates. points: positions of the
// topology's vertices. Reads only the blocks of these cells. Throws Error when the mesh has no such cell, or when a
// record is damaged.
[[nodiscard]] std::map<Index, Vec3d> cell_places(const Topology& topology, const FaceMeshView& points,
                                                 const std::vector<Index>& cells);

} // namespace ciel::store
