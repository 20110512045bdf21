// Numbers the boundary faces of a mesh consecutively, in the order of their face ids. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// Returns for each of `faces` its number among the boundary faces, or `none` for a face between two cells. `faces` may
// be in any order. Reads all faces of the mesh once. Throws Error when the mesh holds an index that is out of range.
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

} // namespace ciel
