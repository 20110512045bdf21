// Faces of each of the C cells: the inverse of owner and neighbour. This is the input form of the paper's appendix A:
// "polyhedra as lists of faces".
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel {

struct CellFaces {
    std::vector<std::uint64_t> begin; // C + 1, into face
    std::vector<Index> face;          // ascending within a cell

    [[nodiscard]] std::span<const Index> of(Index cell) const {
        return std::span(face).subspan(begin[cell], begin[cell + 1] - begin[cell]);
    }
};

[[nodiscard]] CellFaces cell_faces(const FaceMeshView& mesh);

// Throws Error when the arrays break the contract of FaceMeshView. Does not check that cells are closed.
void check_face_mesh(const FaceMeshView& mesh);

} // namespace ciel
