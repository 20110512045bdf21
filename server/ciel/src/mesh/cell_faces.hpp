// Lists the faces of each cell, the form in which the paper's appendix A takes a mesh.
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel::detail {

// The faces are in the order of their owners, so only the other faces of a cell need a list.
struct CellFaces {
    std::vector<Index> own_begin;   // C + 1, for C cells: the first face that the cell owns
    std::vector<Index> other_begin; // C + 1: index in `other` of the cell's first entry
    std::vector<Index> other;       // faces that earlier cells own, cell by cell, ascending in each cell

    [[nodiscard]] std::span<const Index> others(Index cell) const {
        return std::span(other).subspan(other_begin[cell], other_begin[cell + 1] - other_begin[cell]);
    }
    // Calls visit(face) for the faces of the cell, ascending.
    template <class Visit>
    void for_faces(Index cell, Visit&& visit) const {
        for (const Index face : others(cell)) visit(face);
        for (Index face = own_begin[cell]; face < own_begin[cell + 1]; ++face) visit(face);
    }
};

// Returns the faces of all cells. Throws Error when the owners or neighbors in `mesh` are out of range or unsorted.
[[nodiscard]] CellFaces cell_faces(const FaceMeshView& mesh);

// Throws Error when the arrays break the contract of FaceMeshView. Does not check that cells are closed.
void check_face_mesh(const FaceMeshView& mesh);

} // namespace ciel::detail
