// The boundary faces of a mesh, with the arrays that their view refers to.
#pragma once

#include "ciel/numbered_faces.hpp"

namespace ciel::test {

class Boundary {
public:
    // `mesh` must outlive the object.
    explicit Boundary(const FaceMeshView& mesh) : lists_(numbered_faces(mesh, {})), faces_(with_faces(mesh, lists_)) {}
    Boundary(const Boundary&) = delete;
    Boundary& operator=(const Boundary&) = delete;

    [[nodiscard]] const FaceMeshView& faces() const { return faces_; }

private:
    FaceLists lists_;
    FaceMeshView faces_;
};

} // namespace ciel::test
