// The faces of a group, from the shortest list that has them.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

// Ids in the list of boundary faces, or in the list of all faces if one of them is inside the mesh.
struct GroupFaces {
    FaceMeshView mesh; // positions may have to be loaded
    std::vector<Index> ids;
};

// group: of faces. Throws Error when a file is damaged.
[[nodiscard]] GroupFaces faces_of(const Group& group, const Dataset& dataset, const Step& step);

} // namespace ciel::store
