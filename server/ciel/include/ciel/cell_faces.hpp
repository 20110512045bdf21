// Lists of the faces of each cell, made from the owner and neighbour of each face. The paper's appendix A takes meshes
// in this form: "polyhedra as lists of faces".
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel {

struct CellFaces {
    std::vector<std::uint64_t> begin; // one entry per cell and one more: index of the cell's first face in `face`
    std::vector<Index> face;          // face ids, cell by cell, ascending within a cell

    [[nodiscard]] std::span<const Index> of(Index cell) const {
        return std::span(face).subspan(begin[cell], begin[cell + 1] - begin[cell]);
    }
};

[[nodiscard]] CellFaces cell_faces(const FaceMeshView& mesh);

// Throws Error when the arrays break the contract of FaceMeshView. Does not check that cells are closed.
void check_face_mesh(const FaceMeshView& mesh);

} // namespace ciel
