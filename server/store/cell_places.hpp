// Computes the center positions of selected cells of a mesh.
#pragma once

#include "ciel/topology.hpp"

#include <map>

namespace server::store {

// Returns the mean position of each cell's corners, in dataset coordinates. Reads only the blocks of these cells.
// Throws Error when the mesh has no such cell, or when a record is damaged.
[[nodiscard]] std::map<ciel::Index, ciel::Vec3d>
cell_places(const ciel::Topology& topology, const ciel::FaceMeshView& points, const std::vector<ciel::Index>& cells);

} // namespace server::store
