// Computes the center positions of selected cells of a mesh.
#pragma once

#include "ciel/topology.hpp"

#include <map>

namespace ciel::store {

// Returns the mean position of each cell's corners, in dataset coordinates. Reads only the blocks of these cells.
// Throws Error when the mesh has no such cell, or when a record is damaged.
[[nodiscard]] std::map<Index, Vec3d> cell_places(const Topology& topology, const FaceMeshView& points,
                                                 const std::vector<Index>& cells);

} // namespace ciel::store
