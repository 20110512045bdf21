// The boundary faces of a mesh.
#pragma once

#include "ciel/numbered_faces.hpp"
#include "support/kept.hpp"

namespace ciel::test {

class Boundary {
public:
    // The arrays of `mesh` must outlive the object.
    explicit Boundary(const FaceMeshView& mesh)
        : faces_(with_faces(kept(mesh), std::make_shared<const FaceLists>(numbered_faces(mesh, {})))) {}

    [[nodiscard]] const FaceMeshView& faces() const { return faces_; }

private:
    FaceMeshView faces_;
};

} // namespace ciel::test
