// Where single cells of a mesh are.
#pragma once

#include "ciel/face_mesh.hpp"

#include <map>

namespace ciel::store {

// For each of `cells`, which exist, the mean of its corners, in the dataset's coordinates. Looks at all faces once,
// however many cells are asked for. Throws Error when an index leads out of the mesh.
[[nodiscard]] std::map<Index, Vec3d> cell_places(const FaceMeshView& mesh, const std::vector<Index>& cells);

} // namespace ciel::store
