// Boundary faces, numbered consecutively in the order of their ids. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// Returns for each of `faces` (in any order) its number among the boundary faces, or `none` for a face between two
// cells. Reads all faces of the mesh once. Throws Error when an index leads out of the mesh.
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

} // namespace ciel
