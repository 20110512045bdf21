// Cell -> its faces, the inverse of owner and neighbour. C cells. What the paper's appendix A is given: "polyhedra as
// lists of faces".
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

// Throws Error when the arrays break the contract of FaceMeshView; whether cells are closed is not looked at.
void check_face_mesh(const FaceMeshView& mesh);

} // namespace ciel
