// The boundary faces of a mesh with all that they view.
#pragma once

#include "ciel/boundary_faces.hpp"

namespace ciel::test {

class Boundary {
public:
    // `mesh` must outlive the object.
    explicit Boundary(const FaceMeshView& mesh)
        : lists_(boundary_face_lists(mesh)), outside_(lists_.face.size(), none) {
        faces_.mesh = face_mesh_view(mesh.origin, mesh.positions, mesh.cell_types, lists_.face_offset,
                                     lists_.face_vertex, lists_.owner, outside_);
        faces_.face = {lists_.face, mesh.face_count(), nullptr};
    }
    Boundary(const Boundary&) = delete;
    Boundary& operator=(const Boundary&) = delete;

    [[nodiscard]] const BoundaryFaces& faces() const { return faces_; }

private:
    BoundaryFaceLists lists_;
    std::vector<Index> outside_; // the neighbour of each: none
    BoundaryFaces faces_;
};

} // namespace ciel::test
