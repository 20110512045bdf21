// Lists the faces of each cell, the form in which the paper's appendix A takes a mesh.
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel::detail {

struct CellFaces {
    std::vector<std::uint64_t> begin; // C + 1, for C cells: index in `face` of the cell's first face
    std::vector<Index> face;          // face ids, cell by cell, ascending in each cell

    [[nodiscard]] std::span<const Index> of(Index cell) const {
        return std::span(face).subspan(begin[cell], begin[cell + 1] - begin[cell]);
    }
};

// Returns the faces of all cells. Throws Error when an index in `mesh` is out of range.
[[nodiscard]] CellFaces cell_faces(const FaceMeshView& mesh);

// Throws Error when the arrays break the contract of FaceMeshView. Does not check that cells are closed.
void check_face_mesh(const FaceMeshView& mesh);

} // namespace ciel::detail
