// Gives numbers to the boundary faces and to the faces of groups (ciel/numbered_faces.hpp).
#pragma once

#include "ciel/numbered_faces.hpp"

namespace server::store {

struct NumberedGroups {
    ciel::FaceLists faces;                     // the numbered faces
    std::vector<std::vector<ciel::Index>> ids; // by group: the numbers of its faces, ascending, without duplicates
};

// `groups`: ids of faces of the mesh, by group. Reads all faces of the mesh. Throws Error when an index of the mesh or
// an id of a group is out of range.
[[nodiscard]] NumberedGroups number_groups(const ciel::FaceMeshView& mesh,
                                           std::span<const std::vector<ciel::Index>> groups);

} // namespace server::store
