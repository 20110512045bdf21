// Computes the positions of single cells of a mesh.
#pragma once

#include "ciel/face_mesh.hpp"

#include <map>

namespace ciel::store {

// Returns for each of `cells` the mean of its corners, in the dataset's coordinates. REQUIRES: all ids are below
// mesh.cell_count(). Reads all faces once, for any number of cells. Throws Error when the mesh holds an index that is
// out of range.
[[nodiscard]] std::map<Index, Vec3d> cell_places(const FaceMeshView& mesh, const std::vector<Index>& cells);

} // namespace ciel::store
