// The faces of the boundary, numbered through in the order of their ids. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// For each of `faces`, in any order, its number among those of the boundary; `none` for a face between two cells. Looks
// at all faces once. Throws Error when an index leads out of the mesh.
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

} // namespace ciel
