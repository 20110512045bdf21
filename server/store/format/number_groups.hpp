// Numbers the faces that groups have.
#pragma once

#include "ciel/numbered_faces.hpp"

namespace ciel::store {

struct NumberedGroups {
    FaceLists faces;                     // those with numbers
    std::vector<std::vector<Index>> ids; // by group: numbers in ascending order, each once
};

// Returns the boundary faces and all faces inside the mesh that a group has. `groups`: ids of faces of the mesh. Reads
// all faces of the mesh. Throws Error when an index of the mesh or an id of a group is out of range.
[[nodiscard]] NumberedGroups number_groups(const FaceMeshView& mesh, std::span<const std::vector<Index>> groups);

} // namespace ciel::store
